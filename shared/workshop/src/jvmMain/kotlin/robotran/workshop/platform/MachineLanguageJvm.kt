package robotran.workshop.platform

import java.util.Locale

/** Asked once: the app changes the default of the process when another language is chosen. */
private val atStart: String = Locale.getDefault().toLanguageTag()

actual fun machineLanguage(): String = atStart
