package robotran.simulation.messages

import robotran.language.Language
import robotran.language.choose

/**
 * The table of everything that is said of a run: what pupils are told to do, what was missing, why a robot strayed, and what it lacks.
 */
interface SimulationMessages :
    GoalMessages,
    ShortfallMessages,
    DeviationMessages,
    NxtDeviationMessages,
    SensorMessages {
    companion object {
        fun of(language: Language): SimulationMessages =
            language.choose(EnglishSimulationMessages, SpanishSimulationMessages, GermanSimulationMessages)
    }
}
