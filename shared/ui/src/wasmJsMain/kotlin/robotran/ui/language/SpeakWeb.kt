@file:OptIn(ExperimentalWasmJsInterop::class)

package robotran.ui.language

import robotran.language.Language
import robotran.workshop.platform.spokenLanguage

internal actual fun speak(tag: String?) = overrideLanguages(tag, spokenLanguage(tag?.let(Language::of)).tag)

/**
 * Compose asks the browser for its languages, so that is where it has to be told another; screen readers ask the page,
 * which is told [spoken].
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
