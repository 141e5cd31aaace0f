package robotran.workshop.service

import robotran.language.Language
import robotran.workshop.state.Settings

/** The settings of this machine. */
interface Preferences {
    val settings: Settings

    /** The app language, from the settings or the system. */
    val language: Language

    /** The language whose words blocks show and programs of the app have. */
    val words: Language get() = if (settings.hasEnglishWords) Language.ENGLISH else language

    /** Whether animations are reduced: as the pupil has chosen, before that as the system is told. */
    val hasLessMotion: Boolean

    /** Stores [settings] as the new ones. */
    fun change(settings: Settings)
}
