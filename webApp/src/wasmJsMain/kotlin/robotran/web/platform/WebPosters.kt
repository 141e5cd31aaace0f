@file:OptIn(ExperimentalWasmJsInterop::class)

package robotran.web.platform

import kotlinx.coroutines.await
import robotran.ui.poster.POSTER_PIXELS_PER_MILLIMETRE
import robotran.ui.poster.posterSvg
import robotran.workshop.platform.Posters
import robotran.workshop.platform.Printing
import robotran.workshop.state.Poster
import kotlin.io.encoding.Base64
import kotlin.js.Promise

/** Prints with the browser: `page.css` shows only the poster on paper. */
internal object WebPosters : Posters {
    override val canPrint: Boolean = canPrint()

    override fun svg(poster: Poster): String = posterSvg(poster)

    /** The browser draws the SVG, in fonts of its own, which have monospaced letters and emoji. */
    override suspend fun png(poster: Poster): ByteArray? =
        pngOf(posterSvg(poster), POSTER_PIXELS_PER_MILLIMETRE).await<JsString?>()?.let { Base64.decode(it.toString()) }

    override suspend fun print(poster: Poster): Printing {
        printPage(posterSvg(poster))
        return Printing.HandedOver
    }
}

private fun canPrint(): Boolean = js("typeof print === 'function'")

/** The file in Base64; null if the browser does not draw it. */
private fun pngOf(svg: String, pixelsPerMillimetre: Double): Promise<JsString?> = js(
    """new Promise((resolve) => {
        const page = new DOMParser().parseFromString(svg, 'image/svg+xml').documentElement.viewBox.baseVal;
        const picture = new Image();
        picture.addEventListener('error', () => resolve(null));
        picture.addEventListener('load', () => {
            const canvas = document.createElement('canvas');
            canvas.width = Math.round(page.width * pixelsPerMillimetre);
            canvas.height = Math.round(page.height * pixelsPerMillimetre);
            canvas.getContext('2d').drawImage(picture, 0, 0, canvas.width, canvas.height);
            try {
                resolve(canvas.toDataURL('image/png').split(',')[1] || null);
            } catch {
                resolve(null);
            }
        });
        picture.src = 'data:image/svg+xml,' + encodeURIComponent(svg);
    })""",
)

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
