package robotran.tinyvm.link

import robotran.tinyvm.classfile.ClassFile

/**
 * What an object in the heap can be: an instance of a class, or an array.
 *
 * @property id its place among all types of a program.
 * @property descriptor as class files write it, such as `Ljava/lang/String;` or `[I`.
 */
internal sealed class HeapType(val id: Int, val descriptor: String) {
    /** The methods that can be overridden, each at the place all its overriders have, too. */
    abstract val virtualMethods: List<LinkedMethod>

    /** By the number of an interface method what to call, null for nothing; made when all classes are known. */
    abstract val interfaceMethods: Array<LinkedMethod?>

    /** Whether an instance of this type is an instance of [other], as the Java language sees it. */
    abstract fun isA(other: HeapType): Boolean
}

/** @property element the type of its elements if they are objects, null for numbers. */
internal class ArrayType(id: Int, descriptor: String, val element: HeapType?, private val root: LinkedClass) :
    HeapType(id, descriptor) {
    /** How the type of an element is written; a single letter for numbers. */
    val elementDescriptor: String = descriptor.drop(1)

    override val virtualMethods: List<LinkedMethod> get() = root.virtualMethods

    override val interfaceMethods: Array<LinkedMethod?> get() = root.interfaceMethods

    override fun isA(other: HeapType): Boolean = when (other) {
        is LinkedClass -> other === root
        is ArrayType -> other === this || (element != null && other.element != null && element.isA(other.element))
    }
}

/**
 * A class whose fields have their places.
 *
 * @property number its place among the classes of a program, in the order in which they were met.
 * @property isOfProgram false for the classes of the library.
 * @property sourceFile the file its source stands in; null if that goes without saying.
 */
internal class LinkedClass(
    id: Int,
    val number: Int,
    val file: ClassFile,
    val superclass: LinkedClass?,
    val interfaces: List<LinkedClass>,
    val isOfProgram: Boolean,
    val sourceFile: String? = null,
) : HeapType(id, "L${file.name};") {
    val name: String get() = file.name

    /** The name with dots, as programs write it. */
    val sourceName: String get() = file.name.replace('/', '.')

    val isInterface: Boolean get() = file.isInterface

    /** How many superclasses and interfaces stand above it, each way counted. */
    val ancestorCount: Int = 1 + (superclass?.ancestorCount ?: 0) + interfaces.sumOf { it.ancestorCount }

    /** The fields it declares. */
    var fields: List<LinkedField> = emptyList()

    /** The methods it declares. */
    var methods: List<LinkedMethod> = emptyList()

    /** How many words its instances have for their fields, those of the superclasses first. */
    var fieldWords = 0

    /** Which of these words are references. */
    var referenceWords: IntArray = IntArray(0)

    /** How many bytes an instance takes in a real brick's memory. */
    var brickBytes = 0

    override var virtualMethods: List<LinkedMethod> = emptyList()

    override var interfaceMethods: Array<LinkedMethod?> = emptyArray()

    private val ancestors: Set<HeapType> = buildSet {
        superclass?.let { addAll(it.ancestors) }
        interfaces.forEach { addAll(it.ancestors) }
        add(this@LinkedClass)
    }

    /** What runs before the class is first used, null for nothing. */
    val initializer: LinkedMethod? by lazy(LazyThreadSafetyMode.PUBLICATION) {
        methods.find { it.name == "<clinit>" && it.descriptor == "()V" && it.isStatic }
    }

    /** Whether it or a superclass has something to run before it is used. */
    val needsInitializing: Boolean get() = initializer != null || superclass?.needsInitializing == true

    override fun isA(other: HeapType): Boolean = other in ancestors

    /** The field that this class knows by [name], its own or inherited. */
    fun findField(name: String, descriptor: String, isStatic: Boolean): LinkedField? =
        fields.find { it.name == name && it.descriptor == descriptor && it.isStatic == isStatic }
            ?: interfaces.firstNotNullOfOrNull { it.findField(name, descriptor, isStatic) }
            ?: superclass?.findField(name, descriptor, isStatic)

    /** The method that this class knows by [name], its own or inherited. */
    fun findMethod(name: String, descriptor: String): LinkedMethod? =
        methods.find { it.name == name && it.descriptor == descriptor }
            ?: superclass?.findMethod(name, descriptor)
            ?: interfaces.firstNotNullOfOrNull { it.findMethod(name, descriptor) }
}
