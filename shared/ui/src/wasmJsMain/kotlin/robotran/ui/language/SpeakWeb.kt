@file:OptIn(ExperimentalWasmJsInterop::class)

package robotran.ui.language

import robotran.language.Language
import robotran.workshop.platform.appLanguage

internal actual fun speak(tag: String?) = overrideLanguages(tag, appLanguage(tag?.let(Language::of)).tag)

/**
 * Compose reads the browser's languages, so this overrides them. Screen readers read the page's language, which becomes
 * [spoken].
 */
private fun overrideLanguages(tag: String?, spoken: String): Unit = js(
    """{
        document.documentElement.lang = spoken;
        if (tag) {
            Object.defineProperty(navigator, 'languages', { value: [tag], configurable: true });
        } else {
            delete navigator.languages;
        }
    }""",
)
