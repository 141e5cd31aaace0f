import lejos.robotics.RangeFinder;
import lejos.robotics.RangeReading;
import lejos.robotics.RangeReadings;
import lejos.robotics.Touch;
import lejos.robotics.objectdetection.Feature;
import lejos.robotics.objectdetection.FeatureDetector;
import lejos.robotics.objectdetection.FeatureListener;
import lejos.robotics.objectdetection.FusorDetector;
import lejos.robotics.objectdetection.RangeFeatureDetector;
import lejos.robotics.objectdetection.TouchFeatureDetector;

public class Features {
    static float[] ranges = {255};
    static boolean touched;
    static volatile boolean isFound;

    public static void main(String[] arguments) {
        RangeFinder finder = new RangeFinder() {
            public float getRange() {
                return ranges[0];
            }

            public float[] getRanges() {
                return ranges;
            }
        };
        RangeFeatureDetector sonar = new RangeFeatureDetector(finder, 80, 100);
        System.out.println(sonar.scan() == null); // expect true
        ranges = new float[] {40, 60, 120};
        Feature feature = sonar.scan();
        System.out.println(feature.getRangeReading().getRange() + " " + feature.getRangeReadings().getNumReadings()); // expect 40.0 3
        sonar.setMaxDistance(30);
        System.out.println(sonar.scan() == null); // expect true
        System.out.println(sonar.getMaxDistance() + " " + sonar.getDelay() + " " + sonar.isEnabled()); // expect 30.0 100 true
        TouchFeatureDetector bumper = new TouchFeatureDetector(new Touch() {
            public boolean isPressed() {
                return touched;
            }
        });
        System.out.println(bumper.scan() == null); // expect true
        touched = true;
        System.out.println(bumper.scan() != null); // expect true
        FusorDetector both = new FusorDetector();
        both.addDetector(sonar);
        both.addDetector(bumper);
        System.out.println(both.scan() != null); // expect true
        RangeReadings readings = new RangeReadings(2);
        readings.setRange(0, 45, 30);
        readings.setRange(1, 90, -1);
        System.out.println(readings.getRange(0) + " " + readings.getAngle(1) + " " + readings.incomplete()); // expect 30.0 90.0 true
        System.out.println(new RangeReading(10, 20).invalidReading() + " " + new RangeReading(10, -1).invalidReading()); // expect false true
        FeatureListener listener = new FeatureListener() {
            public void featureDetected(Feature found, FeatureDetector detector) {
                detector.enableDetection(false);
                System.out.println("found"); // expect found
                isFound = true;
            }
        };
        bumper.addListener(listener);
        sonar.enableDetection(false);
        while (!isFound) Thread.yield();
    }
}
