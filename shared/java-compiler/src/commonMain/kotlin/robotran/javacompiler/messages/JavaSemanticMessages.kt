package robotran.javacompiler.messages

/** The messages about semantic errors. */
interface JavaSemanticMessages {
    fun doesNotFit(given: String, needed: String): String

    /** A number conversion that may lose information. */
    fun castNumber(type: String): String

    /** [number] has a part behind the point, and the whole-number [type], such as `int`, is needed. */
    fun notWhole(number: String, type: String): String

    /** [number] is a whole one. */
    fun writeWhole(number: String): String

    /** The same for a variable that can also be declared for numbers with a point, by [declaration]. */
    fun writeWholeOrDeclare(number: String, declaration: String): String

    /** The whole [number] does not fit into the [type], such as `byte`. */
    fun tooLargeFor(number: String, type: String): String

    fun declareAsInt(): String

    /** A conversion of an `Object`, such as an element of a `Vector`, to its class. */
    fun castObject(type: String): String

    fun writeFloat(number: String): String

    fun compareWithTwoSigns(): String

    fun compareWithZero(): String

    fun makeText(): String

    fun givesNothing(): String

    fun notInitialized(name: String): String

    fun declaredTwice(name: String): String

    fun returnsNothing(): String

    fun mustReturn(): String

    fun returnValue(): String

    fun neverReached(): String

    fun unhandledException(name: String): String

    fun handleIt(name: String): String

    fun neverThrown(name: String): String

    fun removeCatch(): String

    fun wrongArguments(method: String, needed: String, given: String): String

    fun staticNeeded(name: String): String

    fun makeItStatic(): String

    /** The instance method [name] is called on the class [owner]. */
    fun objectNeeded(name: String, owner: String): String

    fun neverChanges(name: String): String

    fun numberTooLarge(number: String): String

    /** A whole number begins with 0, which makes it octal; [number] is the same without it. */
    fun noLeadingZero(number: String): String

    /** A method that waits gets a number with a part behind the point. */
    fun countsMilliseconds(): String

    /** `wait` is called to let time pass. */
    fun sleepInstead(): String

    /** `notify` or such is called in a static method: it needs an object. */
    fun callOnObject(name: String): String

    /** The inherited method [name] needs an object of [className]. */
    fun callOnNew(className: String, name: String): String

    /** A method announces [exception], and [method], which it replaces, does not. */
    fun announcesMore(exception: String, method: String): String

    fun catchInside(exception: String): String

    fun noEffect(): String

    fun emptyStatement(): String

    fun wrongOperator(operator: String, types: String): String
}

/** The messages about classes and methods as a whole. */
interface JavaClassMessages {
    fun wrongFileName(className: String): String

    fun missingReturnType(): String

    fun writeVoid(): String

    /** The class [name] cannot be instantiated with `new`. */
    fun cannotInstantiate(name: String): String

    /** No constructor of [name] takes [given], types or nothing. */
    fun wrongConstructor(name: String, given: String): String

    /** [ways] are the constructors as a program calls them. */
    fun makeItLike(ways: String): String

    /** The class needs a port; [example] makes an object of it. */
    fun sayWherePluggedIn(example: String): String

    /** The class [name] makes its objects itself. */
    fun madeAlready(name: String): String

    /** [constants] are the objects, such as `Motor.A, Motor.B`. */
    fun useOneOf(constants: String): String

    /** There are no objects of the class [name]: its methods are static. */
    fun callOnClass(name: String): String

    fun extendThread(): String

    fun extendIt(name: String): String

    /** [owner] requires [className] to have a method [method]. */
    fun mustHaveMethod(className: String, method: String, owner: String): String

    fun writePublicMethod(method: String): String

    fun mustBePublic(method: String): String

    fun noMain(): String

    /** There is a method named like `main`, but its declaration is wrong. */
    fun wrongMain(): String

    fun writeMain(): String
}
