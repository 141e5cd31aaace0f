package robotran.workshop.service

import robotran.language.Language
import robotran.workshop.state.Settings

/** What was chosen for this machine. */
interface Preferences {
    val settings: Settings

    /** What the app speaks: as the settings say, or as the machine does. */
    val language: Language
}
