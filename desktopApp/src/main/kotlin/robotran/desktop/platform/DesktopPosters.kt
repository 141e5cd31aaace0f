package robotran.desktop.platform

import androidx.compose.ui.text.font.createFontFamilyResolver
import kotlinx.coroutines.Dispatchers
import kotlinx.coroutines.withContext
import robotran.ui.poster.DrawnPoster
import robotran.ui.poster.posterPng
import robotran.ui.poster.posterSvg
import robotran.workshop.platform.Posters
import robotran.workshop.platform.Printing
import robotran.workshop.state.Poster
import java.awt.print.PageFormat
import java.awt.print.Paper
import java.awt.print.PrinterAbortException
import java.awt.print.PrinterException
import java.awt.print.PrinterJob

/** Prints with the system's print dialog, which can also write a PDF file on most systems. */
internal object DesktopPosters : Posters {
    override val canPrint: Boolean = true

    override fun svg(poster: Poster): String = posterSvg(poster)

    override suspend fun png(poster: Poster): ByteArray = withContext(Dispatchers.Default) {
        posterPng(poster, createFontFamilyResolver())
    }

    override suspend fun print(poster: Poster): Printing {
        val drawn = DrawnPoster(poster)
        return try {
            val job = PrinterJob.getPrinterJob()
            if (job.printService == null) return Printing.Failed("")
            job.jobName = poster.title
            job.setPrintable(PosterPrintable(drawn), pageFormatFor(drawn))
            if (!job.printDialog()) return Printing.Cancelled
            withContext(Dispatchers.IO) { job.print() }
            Printing.HandedOver
        } catch (_: PrinterAbortException) {
            Printing.Cancelled
        } catch (failure: PrinterException) {
            Printing.Failed(failure.message.orEmpty())
        }
    }
}

/** A4 without margins: the poster has its own. */
internal fun pageFormatFor(drawn: DrawnPoster): PageFormat {
    val sides = listOf(drawn.width, drawn.height).map { it / MILLIMETRES_PER_INCH * POINTS_PER_INCH }.sorted()
    val paper = Paper().apply {
        setSize(sides.first(), sides.last())
        setImageableArea(0.0, 0.0, sides.first(), sides.last())
    }
    return PageFormat().apply {
        this.paper = paper
        orientation = if (drawn.isLandscape) PageFormat.LANDSCAPE else PageFormat.PORTRAIT
    }
}

internal const val MILLIMETRES_PER_INCH = 25.4

/** The unit of Java's printing. */
internal const val POINTS_PER_INCH = 72.0
