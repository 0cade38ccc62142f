// The places that the page fills, as they were before: a browser that saves a saved run again, as a
// file, also saves what is in them.
document.querySelector(".places").innerHTML = document.querySelector(".empty-places").textContent;
document.documentElement.className = "recorded opened";
