@file:OptIn(ExperimentalWasmJsInterop::class)

package robotran.ui.language

import robotran.language.Language
import robotran.workshop.platform.appLanguage

internal actual fun speak(tag: String?) = setPageLanguage(appLanguage(tag?.let(Language::of)).tag)

/** Screen readers read it. */
private fun setPageLanguage(tag: String): Unit = js("{ document.documentElement.lang = tag; }")
