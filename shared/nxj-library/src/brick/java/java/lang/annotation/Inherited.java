package java.lang.annotation;

/** Marks annotations that hold for extending classes, too. */
@Documented
@Retention(RetentionPolicy.RUNTIME)
@Target(ElementType.ANNOTATION_TYPE)
public @interface Inherited {
}
