import lejos.nxt.Motor;
import lejos.nxt.SensorPort;
import lejos.nxt.TemperatureSensor;
import lejos.nxt.addon.AccelHTSensor;
import lejos.nxt.addon.RCXLightSensor;
import lejos.nxt.addon.RCXRotationSensor;
import lejos.util.Delay;

/** Shows what sensors of an RCX on the ports 1 and 2 tell, a thermometer on 3, and an acceleration sensor on 4. */
public class OldSensors {
    public static void main(String[] arguments) {
        RCXLightSensor light = new RCXLightSensor(SensorPort.S1);
        RCXRotationSensor axle = new RCXRotationSensor(SensorPort.S2);
        TemperatureSensor thermometer = new TemperatureSensor(SensorPort.S3);
        AccelHTSensor push = new AccelHTSensor(SensorPort.S4);
        Delay.msDelay(100);
        int lit = light.getLightValue();
        light.setFloodlight(false);
        Delay.msDelay(50);
        System.out.println(lit + " " + (light.getLightValue() < lit));
        thermometer.setResolution(TemperatureSensor.RESOLUTION_12BIT);
        System.out.println(thermometer.getTemperature());
        System.out.println(push.getXAccel() + " " + push.getZAccel());
        Motor.A.forward();
        Motor.C.forward();
        int most = 0;
        for (int look = 0; look < 30; look++) {
            Delay.msDelay(10);
            most = Math.max(most, push.getXAccel());
        }
        Delay.msDelay(700);
        Motor.A.stop(true);
        Motor.C.stop();
        Delay.msDelay(100);
        System.out.println(most);
        System.out.println(Motor.A.getTachoCount() - axle.getTachoCount());
        Delay.msDelay(100000);
    }
}
