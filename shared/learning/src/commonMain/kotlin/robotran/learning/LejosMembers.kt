package robotran.learning

import robotran.brick.kind.BrickKind
import robotran.brick.kind.JavaPlatform
import robotran.lejoslibrary.LejosLibrary
import robotran.nxjlibrary.NxjSources

/**
 * A class or member of the brick's class library.
 *
 * @property form its declaration without modifiers.
 * @property type the simple name of its type or return type.
 */
internal class LejosMember(val sentence: String, val form: String, val type: String)

/**
 * A class of the brick's library, read from its source.
 *
 * @property about the entry of the class itself.
 * @property superclass the simple name of the superclass; null if it has no `extends`.
 */
internal class LejosClass(val about: LejosMember, val superclass: String?, val members: Map<String, LejosMember>)

/** The class of the library of a [brick] with this simple name; null if there is none or the library is not loaded. */
internal fun lejosClass(simpleName: String, brick: BrickKind): LejosClass? {
    val source = sourceOf(simpleName, brick)
    if (source == null && brick.java == JavaPlatform.NXJ && NxjSources.known == null) return null
    return classes.getOrPut(brick to simpleName) { CachedClass(source?.let { readClass(simpleName, it) }) }.lejosClass
}

/**
 * Finds the member [name] of the class [simpleName] or a superclass, and the name of its declaring class; null if there
 * is none.
 */
internal fun lejosMember(simpleName: String, name: String, brick: BrickKind): Pair<String, LejosMember>? {
    var owner: String? = simpleName
    while (owner != null) {
        val found = lejosClass(owner, brick) ?: return null
        found.members[name]?.let { return owner to it }
        owner = found.superclass
    }
    return null
}

private class CachedClass(val lejosClass: LejosClass?)

private val classes = mutableMapOf<Pair<BrickKind, String>, CachedClass>()

private fun sourceOf(simpleName: String, brick: BrickKind): String? = when (brick.java) {
    JavaPlatform.LEJOS -> LejosLibrary.classNames.named(simpleName).firstOrNull()?.let(LejosLibrary::source)

    // A program means the NXT's own Color and Point rather than what else is called so.
    JavaPlatform.NXJ -> NxjSources.known?.let { sources ->
        sources.classNames.named(simpleName).minByOrNull { name -> name.count { it == '/' } }?.let(sources::source)
    }

    null -> null
}

private fun Set<String>.named(simpleName: String) = filter { it.substringAfterLast('/') == simpleName }

private fun readClass(simpleName: String, source: String): LejosClass? {
    val declarations = documented(source)
    val head =
        declarations.firstOrNull { simpleName in it.words && (CLASS in it.words || INTERFACE in it.words) }
            ?: return null
    val members = mutableMapOf<String, LejosMember>()
    for (declaration in declarations) {
        if (declaration === head || PRIVATE in declaration.words || declaration.name in members) continue
        members[declaration.name] = declaration.member
    }
    val superclass = head.words.dropWhile { it != EXTENDS }.getOrNull(1)
    return LejosClass(LejosMember(head.sentence, simpleName, simpleName), superclass, members)
}

/** A declaration with the comment above it. */
private class Declaration(val sentence: String, code: String) {
    private val signature = code.trim().substringBefore(
        '{',
    ).substringBefore(" throws ").substringBefore(" = ").substringBefore(';').trim()
    private val beforeBrackets = signature.substringBefore('(').trim()

    val words: List<String> = beforeBrackets.split(' ')
    val name: String get() = words.last()
    val member: LejosMember get() = LejosMember(
        sentence,
        signature.substring(signature.lastIndexOf(name, beforeBrackets.length)),
        type,
    )
    private val type: String get() = words.dropLast(1).lastOrNull().orEmpty().removeSuffix("[]")
}

/** The declarations of [source] with comments, without members that the brick lacks. */
private fun documented(source: String): List<Declaration> {
    val found = mutableListOf<Declaration>()
    val lines = source.lines()
    var index = 0
    while (index < lines.size) {
        if (!lines[index].trim().startsWith(OPENING)) {
            index++
            continue
        }
        val end = (index until lines.size).first { CLOSING in lines[it] }
        val comment = lines.subList(index, end + 1).joinToString(" ", transform = ::withoutCommentSigns)
        if (HIDDEN !in comment) found += Declaration(firstSentence(comment), lines.getOrElse(end + 1) { "" })
        index = end + 1
    }
    return found
}

/** A line of a comment without the comment signs. */
private fun withoutCommentSigns(line: String): String =
    line.trim().removePrefix(OPENING).removePrefix("*").removeSuffix(CLOSING).trim()

/** The first sentence of a comment: up to a full stop before a space, or the end. */
private fun firstSentence(comment: String): String {
    val text = comment.removeSuffix("/").trim()
    val end = text.indexOf(". ")
    return if (end < 0) text else text.take(end + 1)
}

private const val OPENING = "/**"
private const val CLOSING = "*/"
private const val HIDDEN = "@hidden"
private const val CLASS = "class"
private const val INTERFACE = "interface"
private const val EXTENDS = "extends"
private const val PRIVATE = "private"
