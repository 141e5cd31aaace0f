package robotran.tinyvm.link

/**
 * A program whose every class is read, verified and translated. Never changes.
 *
 * @property types all types of objects by their ids.
 * @property classes by their numbers.
 * @property methods by their numbers.
 * @property statics the static fields by their slots.
 * @property texts the texts in the code by their numbers.
 * @property bytes about how many bytes of a brick's memory it takes.
 * @property exceptions the classes of [BuiltInException], in its order.
 * @property text the class of texts, and [textField] its array of characters, of the type [characters].
 * @property thread the class of threads, and [threadRun] what a thread does.
 */
internal class LinkedProgram(
    val main: LinkedMethod,
    val types: List<HeapType>,
    val classes: List<LinkedClass>,
    val methods: List<LinkedMethod>,
    val statics: List<LinkedField>,
    val texts: List<String>,
    val bytes: Int,
    val exceptions: List<LinkedClass>,
    val text: LinkedClass,
    val textField: LinkedField,
    val characters: ArrayType,
    val thread: LinkedClass,
    val threadRun: LinkedMethod,
    val throwable: LinkedClass,
) {
    val throwableMessage: LinkedField? = throwable.findField("message", "Ljava/lang/String;", isStatic = false)
}
