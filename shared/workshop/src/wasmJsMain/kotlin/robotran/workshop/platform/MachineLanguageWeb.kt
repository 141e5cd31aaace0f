@file:OptIn(ExperimentalWasmJsInterop::class)

package robotran.workshop.platform

actual fun systemLanguage(): String = languageOfBrowser()

private fun languageOfBrowser(): String = js("navigator.language || 'en'")
