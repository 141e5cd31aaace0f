package robotran.ui.language

internal actual fun speak(tag: String?) = overrideLanguages(tag)

internal actual fun machineLanguage(): String = languageOfBrowser()

/** Compose asks the browser for its languages, so that is where it has to be told another. */
private fun overrideLanguages(tag: String?): Unit =
    js(
        """{
        if (tag) {
            Object.defineProperty(navigator, 'languages', { value: [tag], configurable: true });
        } else {
            delete navigator.languages;
        }
    }""",
    )

private fun languageOfBrowser(): String = js("navigator.language || 'en'")
