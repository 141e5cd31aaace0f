package robotran.editing

/** The same fields; [next] makes something else of what their changes make. */
fun <T : Any, R : Any> List<Field<T>>.making(next: (T) -> R): List<Field<R>> = map { it.map(next) }

/** The fields, those of groups one by one. */
fun <T : Any> List<Field<T>>.ungrouped(): List<Field<T>> =
    flatMap { if (it is Field.Group) it.fields.ungrouped() else listOf(it) }

/** A choice of a few values, all in sight. */
fun <V, T : Any> chips(tag: String, label: Words, options: List<Option<V>>, chosen: V, with: (V) -> T?): Field<T> =
    Field.Choice(tag, label, options, chosen, ChoiceLook.CHIPS) { value, _ -> with(value) }

/** A choice of many values. */
fun <V, T : Any> menu(tag: String, label: Words, options: List<Option<V>>, chosen: V, with: (V) -> T?): Field<T> =
    Field.Choice(tag, label, options, chosen, ChoiceLook.MENU) { value, _ -> with(value) }

/** A choice of colours. */
fun <V, T : Any> swatches(tag: String, label: Words, options: List<Option<V>>, chosen: V, with: (V) -> T?): Field<T> =
    Field.Choice(tag, label, options, chosen, ChoiceLook.SWATCHES) { value, _ -> with(value) }

/**
 * A number that may be missing.
 *
 * @param switch the tag and the label of the switch that adds it; [number] those of the number itself.
 * @param first the value that it is added with.
 * @param isAllowed whether its presence and its value fit the other fields.
 */
fun <T : Any> optionalNumber(
    switch: Pair<String, Words>,
    number: Pair<String, Words>,
    value: Double?,
    first: Double,
    spec: NumberSpec,
    isAllowed: Boolean = true,
    with: (Double?) -> T?,
): Field<T> = Field.OptionalNumber(
    Field.Flag(switch.first, switch.second, value != null) { on -> with(first.takeIf { on }) },
    value?.let { Field.Number(number.first, number.second, it, spec, with) },
    isAllowed,
)
