package java.lang.annotation;

/** What all annotations extend. */
public interface Annotation {
    /** Gives the class of the annotation. */
    Class<? extends Annotation> annotationType();
}
