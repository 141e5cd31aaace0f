package robotran.projects

import robotran.brick.program.BrickProgram
import robotran.json.JsonCursor
import robotran.projects.messages.reason
import robotran.world.World
import robotran.world.WorldLimits
import robotran.world.file.unknownOf
import robotran.world.file.worldIn

internal fun assignmentIn(cursor: JsonCursor): Assignment = Assignment(
    id = cursor.member("id").text(AssignmentLimits.MAXIMUM_ID_CHARACTERS),
    text = cursor.optional(TEXT)?.let { textIn(it, AssignmentLimits.MAXIMUM_TEXT_CHARACTERS) }.orEmpty(),
    pictures = cursor.optional("pictures")?.items(0..AssignmentLimits.MAXIMUM_PICTURES)?.map(::pictureIn).orEmpty(),
    mayChangeWorld = cursor.optional("mayChangeWorld")?.flag() ?: false,
    languages = cursor.optional("languages")?.items(0..LANGUAGES.size)?.map { it.choice(LANGUAGES) }.orEmpty(),
    words = cursor.optional("words")?.items(0..AssignmentLimits.MAXIMUM_WORDS)
        ?.map { it.text(AssignmentLimits.MAXIMUM_NAME_CHARACTERS) }.orEmpty(),
    hints = cursor.optional("hints")?.items(0..AssignmentLimits.MAXIMUM_HINTS)?.map(::hintIn).orEmpty(),
    due = cursor.optional("due")?.text(AssignmentLimits.MAXIMUM_NAME_CHARACTERS, mayBeEmpty = true).orEmpty(),
    nameWanted = cursor.optional("nameWanted")
        ?.text(AssignmentLimits.MAXIMUM_NAME_CHARACTERS, mayBeEmpty = true).orEmpty(),
    start = programsIn(cursor.optional("start")),
    checks = cursor.optional("checks")?.let(::checksIn),
    solution = programsIn(cursor.optional("solution")),
    unknown = unknownOf(cursor),
)

internal fun programsIn(cursor: JsonCursor?): List<ProjectProgram> =
    cursor?.items(0..BrickProgram.MAX_PROGRAMS).orEmpty().map(::programIn)

private fun pictureIn(cursor: JsonCursor) = AssignmentPicture(
    cursor.member("name").text(AssignmentLimits.MAXIMUM_NAME_CHARACTERS),
    cursor.member("data").let { data ->
        val text = data.longText(AssignmentLimits.MAXIMUM_PICTURE_CHARACTERS)
        if (text.any { it !in BASE64 }) data.refuse(reason { mustBeBase64() })
        text
    },
)

private fun hintIn(cursor: JsonCursor) = AssignmentHint(
    cursor.member(TEXT).text(WorldLimits.MAXIMUM_TASK_CHARACTERS, severalLines = true),
    cursor.optional("when")?.text(AssignmentLimits.MAXIMUM_NAME_CHARACTERS),
    cursor.optional("afterTries")?.wholeNumber(AssignmentLimits.TRIES) ?: 1,
)

private fun checksIn(cursor: JsonCursor): AssignmentChecks {
    val seeds = cursor.member("seeds")
    val first = seeds.member("from").wholeNumber(0..Int.MAX_VALUE)
    val last = seeds.member("to").wholeNumber(first..Int.MAX_VALUE)
    if (last - first >= AssignmentLimits.MAXIMUM_SEEDS) {
        seeds.refuse(reason { tooManySeeds(AssignmentLimits.MAXIMUM_SEEDS) })
    }
    val variations = cursor.optional("variations")?.items(0..AssignmentLimits.MAXIMUM_VARIATIONS).orEmpty()
    return AssignmentChecks(first..last, variations.map(::variationIn))
}

private fun variationIn(cursor: JsonCursor) = WorldVariation(
    cursor.member("name").text(WorldLimits.MAXIMUM_TITLE_CHARACTERS),
    worldIn(cursor.member("world")),
)

internal fun triesIn(cursor: JsonCursor, world: World) = AssignmentTries(
    cursor.member("tries").wholeNumber(0..Int.MAX_VALUE),
    cursor.optional("best")?.let { best ->
        val programs = programsIn(best.member("programs"))
        BestTry(
            programs,
            firstProgramIn(best, programs.size),
            best.optional("inputs")?.let { InputReader(world).read(it) }.orEmpty(),
            resultIn(best.member("result")),
            best.optional("percent")?.wholeNumber(AssignmentLimits.PERCENT),
        )
    },
)

internal fun handInIn(cursor: JsonCursor) = HandIn(
    cursor.member("name").text(AssignmentLimits.MAXIMUM_NAME_CHARACTERS, mayBeEmpty = true),
    cursor.member("tries").wholeNumber(0..Int.MAX_VALUE),
    cursor.optional("result")?.let(::resultIn),
    cursor.member("hash").text(AssignmentLimits.MAXIMUM_ID_CHARACTERS),
    unknownOf(cursor),
)

private fun resultIn(cursor: JsonCursor): TryResult {
    val goals = cursor.member("goals").wholeNumber(0..WorldLimits.MAXIMUM_GOALS)
    return TryResult(
        cursor.member("goalsMet").wholeNumber(0..goals),
        goals,
        cursor.member("milliseconds").longNumber(0..ProjectLimits.MAXIMUM_MILLISECONDS),
        cursor.member("traceHash").text(AssignmentLimits.MAXIMUM_ID_CHARACTERS),
    )
}

internal fun feedbackIn(cursor: JsonCursor) = Feedback(
    cursor.optional("comment")?.let { textIn(it, AssignmentLimits.MAXIMUM_TEXT_CHARACTERS) }.orEmpty(),
    cursor.optional("results")?.items(0..AssignmentLimits.MAXIMUM_VARIATIONS + 1).orEmpty().map { result ->
        val seeds = result.member("seeds").wholeNumber(0..AssignmentLimits.MAXIMUM_SEEDS)
        FeedbackResult(
            result.optional("world")?.text(WorldLimits.MAXIMUM_TITLE_CHARACTERS, mayBeEmpty = true).orEmpty(),
            result.member("seedsMet").wholeNumber(0..seeds),
            seeds,
        )
    },
    unknownOf(cursor),
)

/** Lines of at most [characters] characters together. */
internal fun textIn(cursor: JsonCursor, characters: Int): String {
    val text = textIn(cursor)
    if (text.length > characters) cursor.refuse(reason { mustNotBeLongerThan(characters) })
    return text
}

private val BASE64 = (('A'..'Z') + ('a'..'z') + ('0'..'9') + listOf('+', '/', '=')).toSet()
