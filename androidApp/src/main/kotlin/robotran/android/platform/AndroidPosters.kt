package robotran.android.platform

import android.app.Activity
import android.content.pm.PackageManager
import android.print.PrintAttributes
import android.print.PrintManager
import androidx.compose.ui.text.font.createFontFamilyResolver
import kotlinx.coroutines.Dispatchers
import kotlinx.coroutines.withContext
import robotran.ui.poster.DrawnPoster
import robotran.ui.poster.posterPng
import robotran.ui.poster.posterSvg
import robotran.workshop.platform.Posters
import robotran.workshop.platform.Printing
import robotran.workshop.state.Poster
import java.lang.ref.WeakReference

/** Prints with Android's print dialog, which can also write a PDF file. Only an activity may open it. */
class AndroidPosters internal constructor(private val packages: PackageManager) : Posters {
    private var activity = WeakReference<Activity>(null)

    override val canPrint: Boolean get() = packages.hasSystemFeature(PackageManager.FEATURE_PRINTING)

    /** Must be called in `onCreate`. */
    fun attachTo(activity: Activity) {
        this.activity = WeakReference(activity)
    }

    override fun svg(poster: Poster): String = posterSvg(poster)

    override suspend fun png(poster: Poster): ByteArray? {
        val shown = activity.get() ?: return null
        return withContext(Dispatchers.Default) { posterPng(poster, createFontFamilyResolver(shown)) }
    }

    override suspend fun print(poster: Poster): Printing {
        val shown = activity.get() ?: return Printing.Failed("")
        val manager = shown.getSystemService(PrintManager::class.java) ?: return Printing.Failed("")
        val drawn = DrawnPoster(poster)
        val size = PrintAttributes.MediaSize.ISO_A4.let { if (drawn.isLandscape) it.asLandscape() else it.asPortrait() }
        val wish = PrintAttributes.Builder().setMediaSize(
            size,
        ).setMinMargins(PrintAttributes.Margins.NO_MARGINS).build()
        manager.print(poster.title.ifBlank { "Robotran" }, PosterPrintAdapter(shown, drawn), wish)
        return Printing.HandedOver
    }
}
