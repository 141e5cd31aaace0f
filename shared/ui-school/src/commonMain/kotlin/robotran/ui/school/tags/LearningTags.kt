package robotran.ui.school.tags

import robotran.brick.kind.BrickKind
import robotran.language.ProgramLanguage
import robotran.learning.HintStage

/** The tags of lessons, worlds, examples and help, by which tests and the page find what is on the screen. */
object LearningTags {
    const val AGAIN = "again"
    const val BEGIN_AGAIN = "begin-again"
    const val EXAMPLES_PAGE = "examples-page"
    const val EXAMPLE_CARDS = "example-cards"
    const val EXPLANATION = "explanation"
    const val EXPLANATION_TEXT = "explanation-text"
    const val FIRST_BLOCKS = "first-blocks"
    const val FIRST_RUN = "first-run"
    const val FIRST_TEXT = "first-text"
    const val FOLDED_HINT = "folded-hint"
    const val FOLD_TUTORIAL = "fold-tutorial"
    const val HELP = "help"
    const val HELP_ALL = "help-all"
    const val HELP_CLOSE = "help-close"
    const val HELP_EXAMPLE = "help-example"
    const val HELP_NONE = "help-none"
    const val HELP_SENTENCE = "help-sentence"
    const val HELP_TITLE = "help-title"
    const val HELP_TRY = "help-try"
    const val HELP_WORDS = "help-words"
    const val HINT = "hint"
    const val HINT_WANTED = "hint-wanted"
    const val LEAVE_TUTORIAL = "leave-tutorial"
    const val LESSON_MAP = "lesson-map"
    const val MAP = "map"
    const val MAP_COURSES = "map-courses"
    const val MAP_PAGE = "map-page"
    const val STRANDS = "strands"
    const val NEXT_STEP = "next-step"
    const val PREVIOUS_STEP = "previous-step"
    const val SOLUTION_NOTE = "solution-note"
    const val SOLUTION_WANTED = "solution-wanted"
    const val STEP_DOTS = "step-dots"
    const val STEP_MORE = "step-more"
    const val STEP_TITLE = "step-title"
    const val TASK = "task"
    const val TASK_AND_HELP = "task-and-help"
    const val TASK_LINE = "task-line"
    const val TO_PROGRAM = "to-program"
    const val TASK_STATUS = "task-status"
    const val TEACHERS = "teachers"
    const val TEACHERS_COURSES = "teachers-courses"
    const val TEACHERS_COURSE_MAKE = "teachers-course-make"
    const val TEACHERS_HAND_INS = "teachers-hand-ins"
    const val TEACHERS_MAKE = "teachers-make"
    const val TEACHERS_OPEN = "teachers-open"
    const val TEACHERS_PAGE = "teachers-page"
    const val TRY_LESSONS = "try-lessons"
    const val TRY_SQUARE = "try-square"
    const val TRY_STEP = "try-step"
    const val TRY_ROBOT = "try-robot"
    const val TRY_TEACHERS = "try-teachers"
    const val TRY_TUTORIAL = "try-tutorial"
    const val TRY_WORLDS = "try-worlds"
    const val TUTORIAL = "tutorial"
    const val TUTORIAL_RETURN = "tutorial-return"
    const val TUTORIAL_STEPS = "tutorial-steps"
    const val TUTORIAL_TASK = "tutorial-task"
    const val TUTORIAL_TEXT = "tutorial-text"
    const val WELCOME_SHEET = "welcome-sheet"
    const val WORLDS_NONE = "worlds-none"
    const val WORLDS_PAGE = "worlds-page"
    const val WORLD_CARDS = "world-cards"
    const val WORLD_SEARCH = "world-search"
    const val WORLD_SEARCH_CLEAR = "world-search-clear"

    fun courseSave(name: String) = "course-save-$name"

    fun courseSaved(name: String) = "course-saved-$name"

    fun example(id: String) = "example-$id"

    fun help(language: ProgramLanguage) = "help-${language.name.lowercase()}"

    fun hint(stage: HintStage) = "hint-${stage.name.lowercase()}"

    fun lesson(name: String) = "lesson-$name"

    fun strand(name: String) = "strand-$name"

    fun goTo(strand: String) = "go-to-$strand"

    fun tutorialStep(number: Int) = "tutorial-step-$number"

    fun word(word: String) = "word-$word"

    fun world(name: String) = "world-$name"

    fun worlds(brick: BrickKind?) = "worlds-${brick?.name?.lowercase() ?: "all"}"
}
