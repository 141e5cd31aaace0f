package robotran.android

import android.content.ContentResolver
import android.content.Intent
import android.net.Uri
import androidx.core.content.IntentCompat
import robotran.projects.isLink

/**
 * What another app hands over.
 *
 * @property files where they lie.
 * @property link a link of Robotran's, or a text that is none, which is refused in words; null if there is no text.
 */
internal data class IncomingIntent(val files: List<Uri> = emptyList(), val link: String? = null)

/** What is in [intent]. Only files that another app gives are taken, never a path of this one's own. */
internal fun handedOver(intent: Intent): IncomingIntent = when (intent.action) {
    Intent.ACTION_VIEW -> {
        val place = intent.data
        if (place?.scheme in
            LINK_SCHEMES
        ) {
            IncomingIntent(link = place.toString())
        } else {
            IncomingIntent(listOfNotNull(place).filter(::isGiven))
        }
    }

    Intent.ACTION_SEND -> {
        val file = IntentCompat.getParcelableExtra(intent, Intent.EXTRA_STREAM, Uri::class.java)?.takeIf(::isGiven)
        val text = intent.getCharSequenceExtra(Intent.EXTRA_TEXT)?.toString()?.takeIf { it.isNotBlank() }
        // Some apps tell in words what the file is that comes with them.
        if (file != null) IncomingIntent(listOf(file)) else IncomingIntent(link = text?.let(::linkIn))
    }

    Intent.ACTION_SEND_MULTIPLE -> {
        IncomingIntent(
            IntentCompat.getParcelableArrayListExtra(
                intent,
                Intent.EXTRA_STREAM,
                Uri::class.java,
            ).orEmpty().filter(::isGiven),
        )
    }

    else -> {
        IncomingIntent()
    }
}

private fun isGiven(place: Uri) = place.scheme == ContentResolver.SCHEME_CONTENT

/** The link among the words of a message; all of [text] if there is none. */
private fun linkIn(text: String): String = text.split(' ', '\n', '\t', '\r').firstOrNull(::isLink) ?: text

private val LINK_SCHEMES = setOf("https", "robotran")
