package java.lang.annotation;

/** Says what an annotation can stand before. */
@Documented
@Retention(RetentionPolicy.RUNTIME)
@Target(ElementType.ANNOTATION_TYPE)
public @interface Target {
    /** All that it can stand before. */
    ElementType[] value();
}
