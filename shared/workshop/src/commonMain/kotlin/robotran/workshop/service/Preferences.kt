package robotran.workshop.service

import robotran.language.Language
import robotran.workshop.state.Settings

/** The settings of this machine. */
interface Preferences {
    val settings: Settings

    /** The app language, from the settings or the system. */
    val language: Language

    /** Stores [settings] as the new ones. */
    fun change(settings: Settings)
}
