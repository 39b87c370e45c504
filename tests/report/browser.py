# SPDX-License-Identifier: GPL-3.0-or-later
"""Pages in headless Chromium, in the working folder."""
import json
import re
import shutil
import subprocess
from pathlib import Path

BROWSER = next(filter(None, map(shutil.which, ("chromium", "chromium-browser", "google-chrome"))), None)
HINTS = ("GL Driver Message", "Canvas2D: Multiple readback")  # on what takes long when a test reads pixels
# Shows a page in a frame as wide as a phone, and writes what its layout and its drawings are into its own text.
FRAME = """<body style="margin:0"><iframe src="PAGE" style="border:0;width:WIDTHpx;height:HEIGHTpx"></iframe><pre id="said"></pre><script>
setTimeout(() => {
  const page = document.querySelector("iframe").contentDocument, window_ = document.querySelector("iframe").contentWindow;
  let answer = null;
  ACTION
  setTimeout(() => {
    const inked = (canvas) => { const d = canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height).data; const seen = new Set();
      for (let i = 0; i < d.length; i += 4) if (d[i + 3]) seen.add((d[i] << 16) | (d[i + 1] << 8) | d[i + 2]); return seen.size; };
    document.getElementById("said").textContent = JSON.stringify({
      parts: [...page.querySelectorAll("section")].map((one) => one.id), plots: page.querySelectorAll(".uplot").length,
      colours: [...page.querySelectorAll("canvas")].map(inked), wide: page.documentElement.scrollWidth - window_.innerWidth,
      hidden: [...page.querySelectorAll("section h2")].filter((one) => !one.offsetHeight).length,
      images: page.querySelectorAll("img").length, theme: page.documentElement.dataset.theme,
      film: page.querySelector("#film strong").textContent, reading: page.querySelector(".reading").textContent,
      answer, text: page.body.innerText });
  }, 500);
}, 2500);
</script>"""


def chromium(*words):
    done = subprocess.run([BROWSER, "--headless", "--no-sandbox", "--disable-gpu", "--hide-scrollbars", "--enable-logging=stderr", "--allow-file-access-from-files",
                           "--virtual-time-budget=20000", f"--user-data-dir={Path.cwd() / 'profile'}", *words], capture_output=True, text=True, timeout=100)
    wrong = [line for line in done.stderr.splitlines() if ("CONSOLE" in line or "Uncaught" in line) and not any(hint in line for hint in HINTS)]
    assert not wrong, "\n".join(wrong)
    return done.stdout


def shown(page, width, height=4000, action="", *flags):
    """What the page tells of itself after something was done in it."""
    Path("frame.html").write_text(FRAME.replace("PAGE", page).replace("WIDTH", str(width)).replace("HEIGHT", str(height)).replace("ACTION", action))
    said = re.search(r'<pre id="said">(.*?)</pre>', chromium("--dump-dom", *flags, Path("frame.html").resolve().as_uri()), re.S)[1]
    assert said, "the page did not answer"
    return json.loads(said.replace("&lt;", "<").replace("&gt;", ">").replace("&amp;", "&"))
