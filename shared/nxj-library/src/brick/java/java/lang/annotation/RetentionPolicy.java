package java.lang.annotation;

/** Says how long an annotation is kept. */
public enum RetentionPolicy {
    /** Until the program is compiled. */
    SOURCE,
    /** In the class file. */
    CLASS,
    /** While the program runs. */
    RUNTIME
}
