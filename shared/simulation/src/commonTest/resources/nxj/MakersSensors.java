import lejos.nxt.SensorPort;
import lejos.nxt.addon.AccelMindSensor;
import lejos.nxt.addon.ColorHTSensor;
import lejos.nxt.addon.CompassMindSensor;
import lejos.nxt.addon.OpticalDistanceSensor;
import lejos.robotics.Color;
import lejos.util.Delay;

/** Shows what sensors of HiTechnic and mindsensors on the ports 1 to 4 tell. */
public class MakersSensors {
    public static void main(String[] arguments) {
        ColorHTSensor eye = new ColorHTSensor(SensorPort.S1);
        CompassMindSensor compass = new CompassMindSensor(SensorPort.S2);
        AccelMindSensor level = new AccelMindSensor(SensorPort.S3);
        OpticalDistanceSensor distance = new OpticalDistanceSensor(SensorPort.S4);
        Delay.msDelay(100);
        Color color = eye.getColor();
        System.out.println(eye.getColorID() + " " + (color.getRed() > color.getBlue()));
        System.out.println(eye.getRGBRaw(Color.RED) / 4 - color.getRed());
        System.out.println(compass.getDegrees());
        compass.resetCartesianZero();
        System.out.println(level.getXAccel() + " " + level.getZAccel());
        System.out.println(level.getXTilt() + " " + level.getZTilt());
        System.out.println(distance.getDistance() + " " + distance.getRange());
        System.out.println(eye.getProductID() + " " + level.getVendorID());
        Delay.msDelay(100000);
    }
}
