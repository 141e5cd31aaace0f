package robotran.learning

import robotran.brick.kind.BrickKind
import robotran.brick.kind.JavaPlatform
import robotran.language.Language

/**
 * The help on [word], a class such as `Motor` or a member such as `Motor.forward`: from the help files, or else from
 * the comments of the library.
 */
internal fun lejosHelp(word: String, language: Language, brick: BrickKind): WordHelp? =
    javaWords(brick).help(word, language)
        ?: commentOf(word, brick)?.let { WordHelp(word, it.sentence, Language.ENGLISH, listOf(it.form), null) }

private fun commentOf(word: String, brick: BrickKind): LejosMember? {
    val owner = lejosClass(word.substringBefore('.'), brick)
    return if ('.' in word) owner?.members?.get(word.substringAfter('.')) else owner?.about
}

/** The help on the word at [range] in the Java program [text]. A class or variable and dots may be before it. */
internal fun helpInJava(language: Language, text: String, range: IntRange, brick: BrickKind): WordHelp? {
    val chain = chainUpTo(text, range)
    val word = chain.last()
    if (chain.size == 1) {
        return lejosHelp(word, language, brick)
            ?: inheritedMemberOwner(text, word, brick)?.let { lejosHelp("$it.$word", language, brick) }
    }
    // Motors of an NXT are of a class of their own, but pupils know them as those of Motor.
    if (brick.java == JavaPlatform.NXJ) javaWords(brick).help("${chain.first()}.$word", language)?.let { return it }
    val owner = chain.dropLast(1).fold(null as String?) { type, name -> typeOf(text, type, name, brick) } ?: return null
    return lejosMember(owner, word, brick)?.let { (declaring, _) -> lejosHelp("$declaring.$word", language, brick) }
}

/**
 * The class of [name]: the type of a member of [owner] or, if that is null, a class or a variable's type in the
 * program.
 */
private fun typeOf(text: String, owner: String?, name: String, brick: BrickKind): String? = when {
    owner != null -> lejosMember(owner, name, brick)?.second?.type
    lejosClass(name, brick) != null -> name
    else -> typeOfVariable(text, name, brick)
}

/** The class that the variable [name] is declared with somewhere in [text]. */
private fun typeOfVariable(text: String, name: String, brick: BrickKind): String? {
    val tokens = words(text)
    return tokens.zipWithNext().firstOrNull { (type, variable) -> variable == name && lejosClass(type, brick) != null }
        ?.first
}

/** The class that declares the inherited member [word], which is used without a qualifier in a subclass. */
private fun inheritedMemberOwner(text: String, word: String, brick: BrickKind): String? =
    words(text).zipWithNext().filter { it.first == "extends" }.firstNotNullOfOrNull { (_, parent) ->
        lejosMember(parent, word, brick)?.first
    }

private fun words(text: String): List<String> = text.split(' ', '\n', '\t', '(', ')', ';', ',', '{', '}', '=').filter {
    it.isNotEmpty()
}

/**
 * The chain of names joined by dots up to the word at [range], which comes last. The parentheses of calls are skipped.
 */
private fun chainUpTo(text: String, range: IntRange): List<String> {
    val chain = ArrayDeque(listOf(text.substring(range.first, range.last + 1)))
    var first = range.first
    while (text.getOrNull(first - 1) == '.') {
        var end = first - 1
        if (text.getOrNull(end - 1) == ')') end = text.lastIndexOf('(', end)
        val before = if (end > 0) wordRange(text, end) else null
        if (before == null) break
        chain.addFirst(text.substring(before.first, before.last + 1))
        first = before.first
    }
    return chain
}
