package robotran.ui.language

import java.util.Locale

private val machine: Locale = Locale.getDefault()

internal actual fun speak(tag: String?) {
    val wanted = tag?.let(Locale::forLanguageTag) ?: machine
    if (Locale.getDefault() != wanted) Locale.setDefault(wanted)
}

internal actual fun machineLanguage(): String = machine.toLanguageTag()
