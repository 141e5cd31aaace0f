package robotran.ui.language

import robotran.workshop.platform.systemLanguage
import java.util.Locale

internal actual fun speak(tag: String?) {
    // Reads the system language before the default locale is first changed.
    val ofMachine = systemLanguage()
    val wanted = Locale.forLanguageTag(tag ?: ofMachine)
    if (Locale.getDefault() != wanted) Locale.setDefault(wanted)
}
