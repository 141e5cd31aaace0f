package robotran.lejoslinker.link

import robotran.lejoslinker.messages.ImageMessages

/** What code refers to by numbers. */
internal class LinkedTables(
    val classes: List<ImageClass>,
    val hierarchy: Hierarchy,
    val constants: ConstantTable,
    val errors: ErrorList,
    val messages: ImageMessages,
) {
    /** Where mistakes are that the program makes as a whole. */
    val programPlace = CodePlace(classes.first { it.isEntry }.name)

    val staticFieldCount = classes.sumOf { it.staticFields.size }
}
