// Share: the address for those who follow on their own screens.
import { one } from "page";

const LOCAL = /^(localhost|127\..*)$/;

const address = new URL(".", document.baseURI);
address.search = `follow=${one("[data-text=share]").textContent}`;
one(".address").textContent = address.href;
one("[data-local]").hidden = !LOCAL.test(location.hostname);

// A tab that follows has nothing that commands.
document.documentElement.classList.toggle("following", location.search.includes("follow="));
