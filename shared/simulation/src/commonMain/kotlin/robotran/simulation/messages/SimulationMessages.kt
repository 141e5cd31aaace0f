package robotran.simulation.messages

import robotran.language.Language
import robotran.language.choose

/** The table of everything that is said of a run: what pupils are told to do, and why a robot strayed. */
interface SimulationMessages :
    GoalMessages,
    DeviationMessages {
    companion object {
        fun of(language: Language): SimulationMessages =
            language.choose(EnglishSimulationMessages, SpanishSimulationMessages, GermanSimulationMessages)
    }
}
