@file:OptIn(ExperimentalWasmJsInterop::class)

package robotran.web.platform

import robotran.ui.poster.posterSvg
import robotran.workshop.platform.Posters
import robotran.workshop.platform.Printing
import robotran.workshop.state.Poster

/** Prints with the browser: `page.css` shows only the poster on paper. */
internal object WebPosters : Posters {
    override val canPrint: Boolean = canPrint()

    override fun svg(poster: Poster): String = posterSvg(poster)

    override suspend fun print(poster: Poster): Printing {
        printPage(posterSvg(poster))
        return Printing.HandedOver
    }
}

private fun canPrint(): Boolean = js("typeof print === 'function'")

/** Replaces what an earlier call has left, since not all browsers tell when a print dialog closes. */
private fun printPage(svg: String): Unit = js(
    """{
        document.getElementById('poster')?.remove();
        const drawing = new DOMParser().parseFromString(svg, 'image/svg+xml').documentElement;
        const page = document.createElement('div');
        page.id = 'poster';
        page.className = drawing.viewBox.baseVal.width > drawing.viewBox.baseVal.height ? 'across' : 'upright';
        page.setAttribute('aria-hidden', 'true');
        page.append(document.importNode(drawing, true));
        document.body.append(page);
        addEventListener('afterprint', () => page.remove(), { once: true });
        print();
    }""",
)
