package lejos.robotics.localization;

import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.util.Random;
import lejos.geom.Point;
import lejos.geom.Rectangle;
import lejos.robotics.RangeReadings;
import lejos.robotics.Transmittable;
import lejos.robotics.mapping.RangeMap;
import lejos.robotics.navigation.Move;
import lejos.robotics.navigation.Pose;

/** Many guesses of where a robot is. */
public class MCLParticleSet implements Transmittable {
    private static final float FAR = 10000;
    private static final float LEAST_WEIGHT = 0.01f;

    /** How many times resample tries. */
    public static int maxIterations = 1000;

    private static boolean isTelling;

    private final RangeMap map;
    private final Random random = new Random();
    private MCLParticle[] particles;
    private float divisor = 400;
    private float distanceNoise = 0.2f;
    private float angleNoise = 4;
    private float maxWeight;
    private int border;

    /** Makes so many guesses anywhere in a map, but not nearer to the edge of its rectangle than the border. */
    public MCLParticleSet(RangeMap map, int numParticles, int border) {
        this.map = map;
        this.border = border;
        particles = new MCLParticle[numParticles];
        for (int i = 0; i < numParticles; i++) particles[i] = anywhere();
    }

    /** Makes so many guesses that are likelier than a weight after what was measured; it tries as long as it takes. */
    public MCLParticleSet(RangeMap map, int numParticles, int border, RangeReadings readings, float divisor,
            float minWeight) {
        this.map = map;
        this.border = border;
        particles = new MCLParticle[numParticles];
        tell("New  Particles from readings");
        int tried = 1;
        int made = 0;
        while (made < numParticles) {
            tried++;
            MCLParticle particle = anywhere();
            particle.calculateWeight(readings, map, divisor);
            if (particle.getWeight() <= minWeight) continue;
            particles[made++] = particle;
            tell("generated " + made);
        }
        System.out.println("Total particles tried " + tried);
    }

    /** Makes so many guesses around a place, so far away and turned by so many degrees as a rule. */
    public MCLParticleSet(RangeMap map, int numParticles, Pose initialPose, float radiusNoise, float headingNoise) {
        this.map = map;
        particles = new MCLParticle[numParticles];
        for (int i = 0; i < numParticles; i++) {
            float radius = radiusNoise * (float) random.nextGaussian();
            float angle = (float) (2 * Math.PI * Math.random());
            float x = initialPose.getX() + radius * (float) Math.cos(angle);
            float y = initialPose.getY() + radius * (float) Math.sin(angle);
            float heading = initialPose.getHeading() + headingNoise * (float) random.nextGaussian();
            particles[i] = new MCLParticle(new Pose(x, y, heading));
            tell(" new particle set ");
        }
    }

    private static void tell(String text) {
        if (isTelling) System.out.println(text);
    }

    private MCLParticle anywhere() {
        Rectangle around = map.getBoundingRect();
        while (true) {
            float x = around.x + border + (float) Math.random() * (around.width - border * 2);
            float y = around.y + border + (float) Math.random() * (around.height - border * 2);
            if (map.inside(new Point(x, y))) return new MCLParticle(new Pose(x, y, (float) Math.random() * 360));
        }
    }

    /** Gives how many guesses there are. */
    public int numParticles() {
        return particles.length;
    }

    /** Says whether to write on the display what happens. */
    public void setDebug(boolean debug) {
        isTelling = debug;
        tell("ParticleSet Debug ON ");
    }

    /** Gives the guess at a place. */
    public MCLParticle getParticle(int i) {
        return particles[i];
    }

    /** Takes as many guesses anew, the likelier ones more often; false if there were too few, true even if none. */
    public boolean resample() {
        MCLParticle[] before = particles;
        int all = before.length;
        particles = new MCLParticle[all];
        int count = 0;
        for (int tries = 1; count < all; tries++) {
            if (tries >= maxIterations) return fill(count);
            float chance = (float) Math.random();
            for (int i = 0; i < all && count < all; i++) {
                if (before[i].getWeight() >= chance) particles[count++] = copy(before[i]);
            }
        }
        return true;
    }

    private boolean fill(int count) {
        tell("Lost: count = " + count);
        for (int i = count; i < particles.length; i++) {
            particles[i] = count > 0 ? particles[i % count] : anywhere();
            if (count > 0) particles[i] = copyOfSamePose(particles[i]);
        }
        return count == 0;
    }

    private static MCLParticle copy(MCLParticle particle) {
        Pose pose = particle.getPose();
        MCLParticle copied = new MCLParticle(new Pose(pose.getX(), pose.getY(), pose.getHeading()));
        copied.setWeight(particle.getWeight());
        return copied;
    }

    /** As in leJOS NXJ, guesses that fill up share their place with the first ones, so moves move it several times. */
    private static MCLParticle copyOfSamePose(MCLParticle particle) {
        MCLParticle copied = new MCLParticle(particle.getPose());
        copied.setWeight(particle.getWeight());
        return copied;
    }

    /** Works out how likely each guess is; false if something was not measured, or if no guess is likely. */
    public boolean calculateWeights(RangeReadings rr, RangeMap map) {
        if (rr.incomplete()) {
            tell("range set incomplete");
            return false;
        }
        maxWeight = 0;
        for (MCLParticle particle : particles) {
            particle.calculateWeight(rr, map, divisor);
            maxWeight = Math.max(maxWeight, particle.getWeight());
        }
        tell("Calc Weights Max wt " + maxWeight);
        return maxWeight >= LEAST_WEIGHT;
    }

    /** Moves all guesses as the robot has moved. */
    public void applyMove(Move move) {
        tell("particles applyMove " + move.getMoveType());
        maxWeight = 0;
        for (MCLParticle particle : particles) particle.applyMove(move, distanceNoise, angleNoise);
        tell("particles applyMove Exit");
    }

    /** Gives how likely the likeliest guess is. */
    public float getMaxWeight() {
        float most = 0;
        for (MCLParticle particle : particles) most = Math.max(most, particle.getWeight());
        return most;
    }

    /** Gives how far guesses are from the edge of the map at least. */
    public float getBorder() {
        return border;
    }

    /** Sets how far guesses are from the edge of the map at least. */
    public void setBorder(int border) {
        this.border = border;
    }

    /** Sets by how much the sensor is wrong as a rule; about 14 to begin with. */
    public void setSigma(float sigma) {
        divisor = 2 * sigma * sigma;
    }

    /** Sets which part of a way moves are wrong as a rule; 0.2 to begin with. */
    public void setDistanceNoiseFactor(float factor) {
        distanceNoise = factor;
    }

    /** Sets by how many degrees turns are wrong as a rule; 4 to begin with. */
    public void setAngleNoiseFactor(float factor) {
        angleNoise = factor;
    }

    /** Sets how many times resample tries. */
    public void setMaxIterations(int max) {
        maxIterations = max;
    }

    /** Gives 0. */
    public int getIterations() {
        return 0;
    }

    /** Gives the place of the guess that is nearest to a point. */
    public int findClosest(float x, float y) {
        float least = FAR;
        int place = -1;
        for (int i = 0; i < particles.length; i++) {
            Pose pose = particles[i].getPose();
            float across = pose.getX() - x;
            float up = pose.getY() - y;
            float distance = (float) Math.sqrt(across * across + up * up);
            if (distance < least) {
                least = distance;
                place = i;
            }
        }
        return place;
    }

    /** Writes all of it. */
    public void dumpObject(DataOutputStream dos) throws IOException {
        dos.writeFloat(maxWeight);
        dos.writeInt(particles.length);
        for (MCLParticle particle : particles) {
            Pose pose = particle.getPose();
            dos.writeFloat(pose.getX());
            dos.writeFloat(pose.getY());
            dos.writeFloat(pose.getHeading());
            dos.writeFloat(particle.getWeight());
            dos.flush();
        }
    }

    /** Reads what dumpObject has written. */
    public void loadObject(DataInputStream dis) throws IOException {
        maxWeight = dis.readFloat();
        MCLParticle[] read = new MCLParticle[dis.readInt()];
        for (int i = 0; i < read.length; i++) {
            read[i] = new MCLParticle(new Pose(dis.readFloat(), dis.readFloat(), dis.readFloat()));
            read[i].setWeight(dis.readFloat());
        }
        particles = read;
    }

    /** Writes the place of the guess nearest to a point, what the map says for it, and how likely it is. */
    public void dumpClosest(RangeReadings rr, DataOutputStream dos, float x, float y) throws IOException {
        int closest = findClosest(x, y);
        MCLParticle particle = particles[closest];
        dos.writeInt(closest);
        particle.getReadings(rr, map).dumpObject(dos);
        dos.writeFloat(particle.getWeight());
        dos.flush();
    }
}
