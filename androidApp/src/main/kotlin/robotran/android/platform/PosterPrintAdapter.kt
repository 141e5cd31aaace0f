package robotran.android.platform

import android.content.Context
import android.os.Bundle
import android.os.CancellationSignal
import android.os.ParcelFileDescriptor
import android.print.PageRange
import android.print.PrintAttributes
import android.print.PrintDocumentAdapter
import android.print.PrintDocumentInfo
import android.print.pdf.PrintedPdfDocument
import androidx.compose.ui.geometry.Size
import androidx.compose.ui.graphics.Canvas
import androidx.compose.ui.graphics.drawscope.CanvasDrawScope
import androidx.compose.ui.text.TextMeasurer
import androidx.compose.ui.text.font.FontFamily
import androidx.compose.ui.text.font.createFontFamilyResolver
import androidx.compose.ui.unit.Density
import androidx.compose.ui.unit.LayoutDirection
import robotran.ui.poster.DrawnPoster
import java.io.IOException
import java.io.OutputStream

/** Writes a poster as a PDF file of one page, with lines and letters that stay sharp. */
internal class PosterPrintAdapter(private val context: Context, private val drawn: DrawnPoster) :
    PrintDocumentAdapter() {
    private var attributes: PrintAttributes? = null

    override fun onLayout(
        before: PrintAttributes?,
        now: PrintAttributes,
        cancellation: CancellationSignal?,
        callback: LayoutResultCallback,
        extras: Bundle?,
    ) {
        attributes = now
        val document = PrintDocumentInfo.Builder(FILE_NAME)
            .setContentType(PrintDocumentInfo.CONTENT_TYPE_DOCUMENT)
            .setPageCount(1)
            .build()
        callback.onLayoutFinished(document, before != now)
    }

    override fun onWrite(
        pages: Array<out PageRange>?,
        destination: ParcelFileDescriptor,
        cancellation: CancellationSignal?,
        callback: WriteResultCallback,
    ) {
        try {
            ParcelFileDescriptor.AutoCloseOutputStream(destination).use(::write)
            callback.onWriteFinished(arrayOf(PageRange(0, 0)))
        } catch (failure: IOException) {
            callback.onWriteFailed(failure.message)
        }
    }

    private fun write(file: OutputStream) {
        val document = PrintedPdfDocument(context, checkNotNull(attributes))
        try {
            val page = document.startPage(0)
            val area = Size(page.info.pageWidth.toFloat(), page.info.pageHeight.toFloat())
            val scale = minOf(area.width / drawn.width, area.height / drawn.height).toFloat()
            // Other paper than A4 shows all of the page, too.
            val size = Size(drawn.width.toFloat() * scale, drawn.height.toFloat() * scale)
            // The canvas begins at the margins of the printer; the poster has its own.
            val printable = page.info.contentRect
            page.canvas.translate(-printable.left.toFloat(), -printable.top.toFloat())
            val density = Density(1f)
            val labels = TextMeasurer(createFontFamilyResolver(context), density, LayoutDirection.Ltr)
            CanvasDrawScope().draw(density, LayoutDirection.Ltr, Canvas(page.canvas), size) {
                with(drawn) { draw(labels, FontFamily.Monospace) }
            }
            document.finishPage(page)
            document.writeTo(file)
        } finally {
            document.close()
        }
    }

    private companion object {
        const val FILE_NAME = "robotran.pdf"
    }
}
