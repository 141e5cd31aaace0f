import lejos.nxt.MotorPort;
import lejos.nxt.SensorPort;
import lejos.nxt.TemperatureSensor;
import lejos.nxt.addon.ColorHTSensor;
import lejos.nxt.addon.GyroSensor;
import lejos.nxt.addon.RCXLightSensor;
import lejos.nxt.addon.RCXMotor;
import lejos.nxt.addon.RCXRotationSensor;
import lejos.nxt.addon.RCXThermometer;
import lejos.robotics.Color;
import lejos.util.Delay;

/** Sensors and motors of an RCX, and a gyro, on an NXT; a sensor that sends bytes is not there. */
// sensor 1 at 0: raw 714
// sensor 2 at 0: raw 992
// sensor 2 at 100: raw 864
// sensor 2 at 200: raw 416
// sensor 2 at 300: raw 640
// sensor 3 at 0: raw 625
// sensor 4 at 0: raw 590
public class PartsOfAnRcx {
    public static void main(String[] arguments) {
        Delay.msDelay(20);
        RCXRotationSensor axle = new RCXRotationSensor(SensorPort.S2);
        RCXLightSensor light = new RCXLightSensor(SensorPort.S1);
        System.out.println(light.getLightValue() + " " + light.getNormalizedLightValue()); // expect 30 309
        light.calibrateHigh();
        System.out.println(light.getLow() + " " + light.getHigh()); // expect 0 309
        System.out.println(light.setFloodlight(Color.GREEN) + " " + light.isFloodlightOn()); // expect false true
        RCXThermometer thermometer = new RCXThermometer(SensorPort.S3);
        System.out.println(thermometer.getCelcius() + " " + thermometer.getFahrenheit()); // expect 20.0 68.0
        Delay.msDelay(400);
        System.out.println(axle.getRawTachoCount() + " " + axle.getTachoCount()); // expect 3 67
        axle.resetTachoCount();
        System.out.println(axle.getTachoCount()); // expect 0
        RCXMotor motor = new RCXMotor(MotorPort.B);
        motor.setPower(60); // calls controlMotorById 1 0 0
        motor.forward(); // calls controlMotorById 1 60 0
        motor.backward(); // calls controlMotorById 1 -60 0
        motor.stop(); // calls controlMotorById 1 0 1
        System.out.println(motor.isMoving() + " " + motor.getPower()); // expect false 60
        GyroSensor gyro = new GyroSensor(SensorPort.S4, 600);
        System.out.println(gyro.readValue()); // expect -10
        gyro.recalibrateOffset();
        System.out.println(gyro.readValue() + " " + gyro.getAngularVelocity()); // expect 590 0.0
        ColorHTSensor eye = new ColorHTSensor(SensorPort.S1);
        System.out.println(eye.getColorID() + " " + eye.getRGBRaw(Color.RED)); // expect -1 -1
        eye.setAddress(0x11);
        try {
            eye.setAddress(0x10);
        } catch (IllegalArgumentException e) {
            System.out.println(e.getMessage() + " " + eye.getAddress()); // expect Bad address format 17
        }
        System.out.println(TemperatureSensor.getSamplingDelay(TemperatureSensor.RESOLUTION_9BIT)); // expect 28
        System.out.println(TemperatureSensor.getSamplingDelay(TemperatureSensor.RESOLUTION_12BIT)); // expect 220
        System.exit(0);
    }
}
