package robotran.editing

import robotran.language.Language

/** What a form says, in the language of its reader. */
typealias Words = (Language) -> String

/**
 * A row of a form as data, such as a number with its name, its range and what a change of it makes. Editors list the
 * fields of what they edit; screens draw them.
 *
 * @param T what a change makes: the changed thing, or the edit that changes it; null where nothing changes.
 */
sealed interface Field<out T : Any> {
    /** Its name for tests; empty for rows without a value. */
    val tag: String get() = ""

    val isValid: Boolean get() = true

    /** The same field; [next] makes something else of what its changes make. */
    fun <R : Any> map(next: (T) -> R): Field<R>

    /** A heading above rows. */
    class Heading(val label: Words) : Note()

    class Help(val label: Words) : Note()

    /** A mistake. */
    class Wrong(val label: Words) : Note()

    class Flag<out T : Any>(override val tag: String, val label: Words, val isOn: Boolean, val with: (Boolean) -> T?) :
        Field<T> {
        override fun <R : Any> map(next: (T) -> R) = Flag(tag, label, isOn) { with(it)?.let(next) }
    }

    class Number<out T : Any>(
        override val tag: String,
        val label: Words,
        val value: Double,
        val spec: NumberSpec,
        val with: (Double) -> T?,
    ) : Field<T> {
        override val isValid: Boolean get() = value in spec.range

        override fun <R : Any> map(next: (T) -> R) = Number(tag, label, value, spec) { with(it)?.let(next) }
    }

    /**
     * A number that may be missing.
     *
     * @property switch the field that adds it with its first value, and takes it away.
     * @property number the number itself; null if it is missing.
     */
    class OptionalNumber<out T : Any>(
        val switch: Flag<T>,
        val number: Number<T>?,
        private val isAllowed: Boolean = true,
    ) : Field<T> {
        override val tag: String get() = switch.tag
        override val isValid: Boolean get() = isAllowed && number?.isValid != false

        override fun <R : Any> map(next: (T) -> R) = OptionalNumber(switch.map(next), number?.map(next), isAllowed)
    }

    /**
     * @property hint what stands in an empty one.
     * @property isRefused whether the last edit was refused because of its text.
     */
    class Text<out T : Any>(
        override val tag: String,
        val label: Words,
        val text: String,
        val spec: TextSpec,
        val hint: Words? = null,
        val isRefused: Boolean = false,
        val with: (String) -> T?,
    ) : Field<T> {
        override val isValid: Boolean get() = spec.accepts(text)

        override fun <R : Any> map(next: (T) -> R) = Text(tag, label, text, spec, hint, isRefused) {
            with(it)?.let(next)
        }
    }

    /**
     * One of several values.
     *
     * @property shown what a closed menu says.
     * @property with may take names for what has none from the language.
     */
    class Choice<V, out T : Any>(
        override val tag: String,
        val label: Words,
        val options: List<Option<V>>,
        val chosen: V,
        val look: ChoiceLook,
        val shown: Words = { language -> options.first { it.value == chosen }.label(language) },
        val with: (V, Language) -> T?,
    ) : Field<T> {
        override fun <R : Any> map(next: (T) -> R) =
            Choice(tag, label, options, chosen, look, shown) { value, language ->
                with(value, language)?.let(next)
            }
    }

    /** Fields that belong together, close to each other. */
    class Group<out T : Any>(val fields: List<Field<T>>, private val isAllowed: Boolean = true) : Field<T> {
        override val isValid: Boolean get() = isAllowed && fields.all { it.isValid }

        override fun <R : Any> map(next: (T) -> R) = Group(fields.map { it.map(next) }, isAllowed)
    }

    /**
     * Several like things, of which the form shows one at a time.
     *
     * @property names what they are called.
     * @property fields those of the thing with a given index.
     */
    class OneOf<out T : Any>(
        override val tag: String,
        val label: Words,
        val names: List<Words>,
        val fields: (Int) -> List<Field<T>>,
    ) : Field<T> {
        override fun <R : Any> map(next: (T) -> R) =
            OneOf(tag, label, names) { one -> fields(one).map { it.map(next) } }
    }

    /** Buttons side by side. */
    class Buttons<out T : Any>(val buttons: List<Option<T>>) : Field<T> {
        override fun <R : Any> map(next: (T) -> R) = Buttons(buttons.map { Option(next(it.value), it.label, it.tag) })
    }

    /** A row that changes nothing. */
    sealed class Note : Field<Nothing> {
        override fun <R : Any> map(next: (Nothing) -> R): Field<R> = this
    }
}

/** A value that can be chosen, and what it is called. */
class Option<out V>(val value: V, val label: Words, val tag: String = "")

enum class ChoiceLook { CHIPS, MENU, SWATCHES }
