package robotran.workshop.state

import robotran.blockediting.shown.shownCode
import robotran.language.Language
import robotran.learning.Hint
import robotran.learning.Lesson
import robotran.learning.LessonText
import robotran.learning.withCode
import robotran.programs.support
import robotran.robolang.words.Vocabulary

/**
 * What [lesson] says to a pupil who sees its programs in blocks that show [words]: program text in it reads as on blocks.
 * English stands on blocks as it is written.
 */
internal fun textOnBlocks(lesson: Lesson, language: Language, words: Language): LessonText {
    val text = lesson.text(language, inBlocks = true, words)
    if (words == Language.ENGLISH || !lesson.programLanguage.support.hasBlocks) return text
    return known.getOrPut(Triple(lesson, language, words)) { text.withCode { onBlocks(it, words) } }
}

/** This hint for the task of [lesson] as a pupil reads it whose blocks show [words]. */
internal fun Hint.onBlocks(lesson: Lesson, words: Language): Hint =
    if (words == Language.ENGLISH || !lesson.programLanguage.support.hasBlocks) {
        this
    } else {
        copy(textInBlocks = withCode(textInBlocks) { onBlocks(it, words) })
    }

private fun onBlocks(code: String, words: Language): String = Vocabulary.of(words).let { shownCode(code, it, it) }

/** One for each lesson that was opened: screens ask in each frame. */
private val known = HashMap<Triple<Lesson, Language, Language>, LessonText>()
