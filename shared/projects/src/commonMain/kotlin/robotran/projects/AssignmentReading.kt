package robotran.projects

import robotran.brick.program.BrickProgram
import robotran.json.JsonCursor
import robotran.projects.messages.told
import robotran.world.World
import robotran.world.WorldLimits
import robotran.world.file.unknownOf
import robotran.world.file.worldIn

internal fun assignmentIn(place: JsonCursor): Assignment = Assignment(
    id = place.member("id").text(AssignmentLimits.MAXIMUM_ID_CHARACTERS),
    text = place.optional(TEXT)?.let { textIn(it, AssignmentLimits.MAXIMUM_TEXT_CHARACTERS) }.orEmpty(),
    pictures = place.optional("pictures")?.items(0..AssignmentLimits.MAXIMUM_PICTURES)?.map(::pictureIn).orEmpty(),
    mayChangeWorld = place.optional("mayChangeWorld")?.flag() ?: false,
    languages = place.optional("languages")?.items(0..LANGUAGES.size)?.map { it.choice(LANGUAGES) }.orEmpty(),
    words = place.optional("words")?.items(0..AssignmentLimits.MAXIMUM_WORDS)
        ?.map { it.text(AssignmentLimits.MAXIMUM_NAME_CHARACTERS) }.orEmpty(),
    hints = place.optional("hints")?.items(0..AssignmentLimits.MAXIMUM_HINTS)?.map(::hintIn).orEmpty(),
    due = place.optional("due")?.text(AssignmentLimits.MAXIMUM_NAME_CHARACTERS, mayBeEmpty = true).orEmpty(),
    nameWanted = place.optional("nameWanted")
        ?.text(AssignmentLimits.MAXIMUM_NAME_CHARACTERS, mayBeEmpty = true).orEmpty(),
    start = programsIn(place.optional("start")),
    checks = place.optional("checks")?.let(::checksIn),
    solution = programsIn(place.optional("solution")),
    unknown = unknownOf(place),
)

internal fun programsIn(place: JsonCursor?): List<ProjectProgram> =
    place?.items(0..BrickProgram.MAX_PROGRAMS).orEmpty().map(::programIn)

private fun pictureIn(place: JsonCursor) = AssignmentPicture(
    place.member("name").text(AssignmentLimits.MAXIMUM_NAME_CHARACTERS),
    place.member("data").let { data ->
        val text = data.longText(AssignmentLimits.MAXIMUM_PICTURE_CHARACTERS)
        if (text.any { it !in BASE64 }) data.refuse(told { mustBeBase64() })
        text
    },
)

private fun hintIn(place: JsonCursor) = AssignmentHint(
    place.member(TEXT).text(WorldLimits.MAXIMUM_TASK_CHARACTERS, severalLines = true),
    place.optional("when")?.text(AssignmentLimits.MAXIMUM_NAME_CHARACTERS),
    place.optional("afterTries")?.wholeNumber(AssignmentLimits.TRIES) ?: 1,
)

private fun checksIn(place: JsonCursor): AssignmentChecks {
    val seeds = place.member("seeds")
    val first = seeds.member("from").wholeNumber(0..Int.MAX_VALUE)
    val last = seeds.member("to").wholeNumber(first..Int.MAX_VALUE)
    if (last - first >= AssignmentLimits.MAXIMUM_SEEDS) {
        seeds.refuse(told { tooManySeeds(AssignmentLimits.MAXIMUM_SEEDS) })
    }
    val variations = place.optional("variations")?.items(0..AssignmentLimits.MAXIMUM_VARIATIONS).orEmpty()
    return AssignmentChecks(first..last, variations.map(::variationIn))
}

private fun variationIn(place: JsonCursor) = WorldVariation(
    place.member("name").text(WorldLimits.MAXIMUM_TITLE_CHARACTERS),
    worldIn(place.member("world")),
)

internal fun triesIn(place: JsonCursor, world: World) = AssignmentTries(
    place.member("tries").wholeNumber(0..Int.MAX_VALUE),
    place.optional("best")?.let { best ->
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

internal fun handInIn(place: JsonCursor) = HandIn(
    place.member("name").text(AssignmentLimits.MAXIMUM_NAME_CHARACTERS, mayBeEmpty = true),
    place.member("tries").wholeNumber(0..Int.MAX_VALUE),
    place.optional("result")?.let(::resultIn),
    place.member("hash").text(AssignmentLimits.MAXIMUM_ID_CHARACTERS),
    unknownOf(place),
)

private fun resultIn(place: JsonCursor): TryResult {
    val goals = place.member("goals").wholeNumber(0..WorldLimits.MAXIMUM_GOALS)
    return TryResult(
        place.member("goalsMet").wholeNumber(0..goals),
        goals,
        place.member("milliseconds").longNumber(0..ProjectLimits.MAXIMUM_MILLISECONDS),
        place.member("traceHash").text(AssignmentLimits.MAXIMUM_ID_CHARACTERS),
    )
}

internal fun feedbackIn(place: JsonCursor) = Feedback(
    place.optional("comment")?.let { textIn(it, AssignmentLimits.MAXIMUM_TEXT_CHARACTERS) }.orEmpty(),
    place.optional("results")?.items(0..AssignmentLimits.MAXIMUM_VARIATIONS + 1).orEmpty().map { result ->
        val seeds = result.member("seeds").wholeNumber(0..AssignmentLimits.MAXIMUM_SEEDS)
        FeedbackResult(
            result.optional("world")?.text(WorldLimits.MAXIMUM_TITLE_CHARACTERS, mayBeEmpty = true).orEmpty(),
            result.member("seedsMet").wholeNumber(0..seeds),
            seeds,
        )
    },
    unknownOf(place),
)

/** Lines of at most [characters] characters together. */
internal fun textIn(place: JsonCursor, characters: Int): String {
    val text = textIn(place)
    if (text.length > characters) place.refuse(told { mustNotBeLongerThan(characters) })
    return text
}

private val BASE64 = (('A'..'Z') + ('a'..'z') + ('0'..'9') + listOf('+', '/', '=')).toSet()
