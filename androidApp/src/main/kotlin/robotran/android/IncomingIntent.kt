package robotran.android

import android.content.ContentResolver
import android.content.Intent
import android.net.Uri
import androidx.core.content.IntentCompat
import robotran.projects.isLink

/**
 * The content of an intent from another app.
 *
 * @property files the URIs of the files.
 * @property link a Robotran link, or other text, which is rejected with a message; null if there is no text.
 */
internal data class IncomingIntent(val files: List<Uri> = emptyList(), val link: String? = null)

/** Parses [intent]. Accepts only files of other apps, never a path inside this app. */
internal fun parseIntent(intent: Intent): IncomingIntent = when (intent.action) {
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
        // Some apps add a text that describes the file.
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

    else -> IncomingIntent()
}

private fun isGiven(uri: Uri) = uri.scheme == ContentResolver.SCHEME_CONTENT

/** The first link in a message; all of [text] if it has none. */
private fun linkIn(text: String): String = text.split(' ', '\n', '\t', '\r').firstOrNull(::isLink) ?: text

private val LINK_SCHEMES = setOf("https", "robotran")
