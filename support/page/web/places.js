// The places that a saved run fills, as they were before: a browser that saves it again, as a file,
// also saves what is in them. The page is shown only now: a site may forbid its modules.
import { one } from "page";

one(".places").innerHTML = one(".empty-places").textContent;
document.documentElement.className = "recorded opened";
