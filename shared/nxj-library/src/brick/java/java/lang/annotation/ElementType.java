package java.lang.annotation;

/** Says what an annotation can stand before. */
public enum ElementType {
    /** Annotations. */
    ANNOTATION_TYPE,
    /** Constructors. */
    CONSTRUCTOR,
    /** Fields. */
    FIELD,
    /** Variables of a method. */
    LOCAL_VARIABLE,
    /** Methods. */
    METHOD,
    /** Packages. */
    PACKAGE,
    /** Parameters of a method. */
    PARAMETER,
    /** Classes, interfaces, enums and annotations. */
    TYPE
}
