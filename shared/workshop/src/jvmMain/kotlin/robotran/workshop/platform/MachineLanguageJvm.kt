package robotran.workshop.platform

import java.util.Locale

/** Read once, since the app changes the default locale of the process when the user selects another language. */
private val atStart: String = Locale.getDefault().toLanguageTag()

actual fun systemLanguage(): String = atStart
