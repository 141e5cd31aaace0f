package robotran.tinyvm.link

import robotran.tinyvm.classfile.ClassFile
import robotran.tinyvm.classfile.wordsOf

/**
 * The type of an object in the heap: a class or an array type.
 *
 * @property id the index among all types of a program.
 * @property descriptor as in class files, such as `Ljava/lang/String;` or `[I`.
 */
internal sealed class HeapType(val id: Int, val descriptor: String) {
    /** The overridable methods; an overriding method has the same index as the method it overrides. */
    abstract val virtualMethods: List<LinkedMethod>

    /** The method to call for each interface method number, null for none; filled when all classes are known. */
    abstract val interfaceMethods: Array<LinkedMethod?>

    /** Whether an instance of this type is an instance of [other] in the Java language. */
    abstract fun isA(other: HeapType): Boolean
}

/** @property element the element type if the elements are objects, null for numbers. */
internal class ArrayType(
    id: Int,
    descriptor: String,
    val element: HeapType?,
    private val root: LinkedClass,
    private val isExact: Boolean,
) : HeapType(id, descriptor) {
    /** The descriptor of an element; a single letter for numbers. */
    val elementDescriptor: String = descriptor.drop(1)

    /** The words of an element. */
    val elementWords: Int = if (isExact) wordsOf(elementDescriptor) else 1

    override val virtualMethods: List<LinkedMethod> get() = root.virtualMethods

    override val interfaceMethods: Array<LinkedMethod?> get() = root.interfaceMethods

    override fun isA(other: HeapType): Boolean = when (other) {
        is LinkedClass -> other === root || (isExact && other.name in INTERFACES)
        is ArrayType -> other === this || (element != null && other.element != null && element.isA(other.element))
    }

    private companion object {
        /** The interfaces of all arrays. */
        val INTERFACES = setOf("java/lang/Cloneable", "java/io/Serializable")
    }
}

/**
 * A class with the layout of its members.
 *
 * @property number the index among the classes of a program, in the order of linking.
 * @property brickNumber the number that a brick shows for an uncaught exception of this class; see [SpecialNumbers].
 * @property isOfProgram false for the classes of the library.
 * @property sourceFile the source file; null if the program has only one.
 */
internal class LinkedClass(
    id: Int,
    val number: Int,
    val brickNumber: Int,
    val file: ClassFile,
    val superclass: LinkedClass?,
    val interfaces: List<LinkedClass>,
    val isOfProgram: Boolean,
    val sourceFile: String? = null,
) : HeapType(id, "L${file.name};") {
    val name: String get() = file.name

    /** The name with dots, as in source code. */
    val sourceName: String get() = file.name.replace('/', '.')

    val isInterface: Boolean get() = file.isInterface

    /** The number of superclasses and interfaces, plus one; each path to an interface counts. */
    val ancestorCount: Int = 1 + (superclass?.ancestorCount ?: 0) + interfaces.sumOf { it.ancestorCount }

    /** The declared fields. */
    var fields: List<LinkedField> = emptyList()

    /** The declared methods. */
    var methods: List<LinkedMethod> = emptyList()

    /** The field words of an instance; the fields of superclasses come first. */
    var fieldWords = 0

    /** The indices of the field words that are references. */
    var referenceWords: IntArray = IntArray(0)

    /** Bytes that an instance takes on a real brick. */
    var brickBytes = 0

    override var virtualMethods: List<LinkedMethod> = emptyList()

    override var interfaceMethods: Array<LinkedMethod?> = emptyArray()

    private val ancestors: Set<HeapType> = buildSet {
        superclass?.let { addAll(it.ancestors) }
        interfaces.forEach { addAll(it.ancestors) }
        add(this@LinkedClass)
    }

    /** The static initializer, null if there is none. */
    val initializer: LinkedMethod? by lazy(LazyThreadSafetyMode.PUBLICATION) {
        methods.find { it.name == "<clinit>" && it.descriptor == "()V" && it.isStatic }
    }

    /** Whether this class or a superclass has a static initializer. */
    val needsInitializing: Boolean get() = initializer != null || superclass?.needsInitializing == true

    override fun isA(other: HeapType): Boolean = other in ancestors

    /** The instance fields in the order of their places in an object, inherited ones first. */
    val instanceFields: List<LinkedField> get() = superclass?.instanceFields.orEmpty() + fields.filter { !it.isStatic }

    /** Finds a declared or inherited field. */
    fun findField(name: String, descriptor: String, isStatic: Boolean): LinkedField? =
        fields.find { it.name == name && it.descriptor == descriptor && it.isStatic == isStatic }
            ?: interfaces.firstNotNullOfOrNull { it.findField(name, descriptor, isStatic) }
            ?: superclass?.findField(name, descriptor, isStatic)

    /** Finds a declared or inherited method. */
    fun findMethod(name: String, descriptor: String): LinkedMethod? =
        methods.find { it.name == name && it.descriptor == descriptor }
            ?: superclass?.findMethod(name, descriptor)
            ?: interfaces.firstNotNullOfOrNull { it.findMethod(name, descriptor) }
}
