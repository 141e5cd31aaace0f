@file:OptIn(ExperimentalWasmJsInterop::class)

package robotran.web.window

import androidx.compose.ui.unit.Dp
import androidx.compose.ui.unit.dp
import kotlinx.browser.document
import org.w3c.dom.HTMLElement

/** The usable part of the page: without the on-screen keyboard, notches and rounded corners. */
internal class CanvasLayout(body: HTMLElement) {
    val element: HTMLElement = document.createElement("div") as HTMLElement

    init {
        // Set one by one, since a strict content security policy forbids style attributes.
        for ((name, value) in STYLE) element.style.setProperty(name, value)
        body.appendChild(element)
    }

    /**
     * Reports its width and height in CSS pixels, and the height covered by a keyboard, to [tell] now and after each
     * change.
     */
    fun whenChanged(tell: (width: Int, height: Int, covered: Dp) -> Unit) =
        follow(element) { width, height, covered -> tell(width, height, covered.dp) }

    private companion object {
        val STYLE = mapOf(
            "position" to "fixed",
            "box-sizing" to "border-box",
            "overflow" to "hidden",
            "padding" to SIDES.joinToString(" ") { "env(safe-area-inset-$it)" },
        )
    }
}

private val SIDES = listOf("top", "right", "bottom", "left")

/** Positions [element] over the visible part of the page, on each change, and reports its inner size. */
private fun follow(element: HTMLElement, tell: (Int, Int, Int) -> Unit): Unit = js(
    """{
        const view = window.visualViewport;
        const lay = () => {
            // Pages that are drawn larger than they are show a part of themselves: that is no keyboard.
            const zoomed = view && view.scale > 1.01;
            const width = view && !zoomed ? view.width : innerWidth;
            const height = view && !zoomed ? view.height : innerHeight;
            element.style.left = (view && !zoomed ? view.offsetLeft : 0) + 'px';
            element.style.top = (view && !zoomed ? view.offsetTop : 0) + 'px';
            element.style.width = width + 'px';
            element.style.height = height + 'px';
            element.scrollTop = 0;
            element.scrollLeft = 0;
            const edges = getComputedStyle(element);
            const across = parseFloat(edges.paddingLeft) + parseFloat(edges.paddingRight);
            const down = parseFloat(edges.paddingTop) + parseFloat(edges.paddingBottom);
            tell(Math.floor(width - across), Math.floor(height - down), Math.max(0, Math.round(innerHeight - height)));
        };
        addEventListener('resize', lay);
        addEventListener('orientationchange', lay);
        element.addEventListener('scroll', lay);
        if (view) {
            view.addEventListener('resize', lay);
            view.addEventListener('scroll', lay);
        }
        lay();
    }""",
)
