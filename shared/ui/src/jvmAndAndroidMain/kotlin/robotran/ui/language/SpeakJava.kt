package robotran.ui.language

import robotran.workshop.platform.machineLanguage
import java.util.Locale

internal actual fun speak(tag: String?) {
    // Asks for the machine's language before the default is changed for the first time.
    val ofMachine = machineLanguage()
    val wanted = Locale.forLanguageTag(tag ?: ofMachine)
    if (Locale.getDefault() != wanted) Locale.setDefault(wanted)
}
