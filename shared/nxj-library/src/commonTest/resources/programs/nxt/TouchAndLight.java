import lejos.nxt.LightSensor;
import lejos.nxt.SensorPort;
import lejos.nxt.TouchSensor;

// sensor 1 at 0: raw 1023
// sensor 1 at 100: raw 183
// sensor 3 at 0: raw 600
// sensor 3 at 100: raw 500
public class TouchAndLight {
    public static void main(String[] arguments) throws InterruptedException {
        TouchSensor touch = new TouchSensor(SensorPort.S1);
        LightSensor light = new LightSensor(SensorPort.S3);
        Thread.sleep(50);
        System.out.println(touch.isPressed());
        System.out.println(light.getNormalizedLightValue() + " " + light.getLightValue()); // screen 423 41
        light.calibrateLow();
        Thread.sleep(100);
        System.out.println(touch.isPressed()); // screen true
        light.calibrateHigh();
        System.out.println(light.getLow() + " " + light.getHigh() + " " + light.getLightValue()); // screen 423 523 100
        System.out.println(light.isFloodlightOn()); // screen true
        light.setFloodlight(false);
        System.out.println(light.isFloodlightOn() + " " + light.getFloodlight()); // screen false -1
        System.out.println(SensorPort.S1.readRawValue() + " " + SensorPort.S1.readBooleanValue()); // screen 183 true
        System.out.println(SensorPort.S1.getId() + " " + SensorPort.getInstance(3).getId()); // screen 0 3
        Thread.sleep(300);
    }
}
