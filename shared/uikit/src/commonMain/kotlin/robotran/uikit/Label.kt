package robotran.uikit

import robotran.language.Language

/** A text of the screen without parameters, such as `RunTexts::pause`, for code that chooses it outside of a composition. */
typealias Label = (Language) -> String
