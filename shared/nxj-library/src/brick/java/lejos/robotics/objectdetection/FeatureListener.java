package lejos.robotics.objectdetection;

/** Is told what a FeatureDetector finds. */
public interface FeatureListener {
    /** Something was found. */
    void featureDetected(Feature feature, FeatureDetector detector);
}
