package lejos.nxt;

/** Where one motor should be at each moment, and what power brings it there. */
class MotorMove {
    private static final int NO_LIMIT = 0x7FFFFFFF;

    // What the motor is doing.
    private static final int FREE = 0;
    private static final int ROLLING = 1;
    private static final int HOLDING = 2;
    private static final int MOVING = 3;
    private static final int SETTLING = 4;

    // How strongly the power depends on the error, on its sum and on its change.
    private static final float MOVE_P = 6f;
    private static final float MOVE_I = 0.04f;
    private static final float MOVE_D = 22f;
    private static final float HOLD_P = 2f;
    private static final float HOLD_I = 0.04f;
    private static final float HOLD_D = 8f;

    /** The milliseconds after which a motor that is near enough has arrived. */
    private static final int SETTLE_TIME = 100;

    /** The milliseconds after which any motor has arrived. */
    private static final int LONGEST_SETTLE_TIME = 500;

    /** What is near enough, in degrees. */
    private static final float NEAR = 2f;

    private final NXTRegulatedMotor motor;
    private final TachoMotorPort port;
    private int state = FREE;

    // Where the motor should be: whole degrees, and what is to be added, so that long ways stay exact.
    private int degrees;
    private float fraction;
    private float velocity;

    // What the velocity is to become, and how fast. A motor that brakes for its limit needs just this deceleration.
    private float target;
    private float acceleration;
    private boolean isBraking;
    private float deceleration;
    private int limit;

    // The move after the motor has stopped.
    private boolean hasNext;
    private float nextSpeed;
    private int nextLimit;

    private int arrivedAt;
    private boolean isStalled;
    private int stallError = 50;
    private int stallCycles = 1000;
    private int stalledFor;

    private float fastError;
    private float slowError;
    private float basePower;

    private boolean isToTell;
    private int tachoAtEnd;

    MotorMove(NXTRegulatedMotor motor, TachoMotorPort port) {
        this.motor = motor;
        this.port = port;
    }

    boolean isActive() {
        return state != FREE;
    }

    boolean isHolding() {
        return state == HOLDING;
    }

    boolean isMoving() {
        return state >= MOVING || state == ROLLING;
    }

    boolean isStalled() {
        return isStalled;
    }

    float getVelocity() {
        return velocity;
    }

    int getLimit() {
        return hasNext ? nextLimit : limit;
    }

    int getPosition() {
        return state == FREE || state == ROLLING ? port.getTachoCount() : degrees + Math.round(fraction);
    }

    void setStallThreshold(int error, int cycles) {
        stallError = error;
        stallCycles = cycles;
    }

    void setSpeed(float speed) {
        nextSpeed = speed;
        if (state == MOVING && target != 0) {
            target = target < 0 ? -speed : speed;
            isBraking = false;
        }
    }

    void setAcceleration(float acceleration) {
        this.acceleration = acceleration;
        isBraking = false;
    }

    void resetTachoCount() {
        degrees -= port.getTachoCount();
        port.resetTachoCount();
    }

    /** Begins a move to a limit, or stops with speed 0, and says whether the motor was standing. */
    boolean begin(float speed, float acceleration, int limit) {
        boolean wasMoving = isMoving();
        if (state == FREE || state == ROLLING) takeOver();
        this.acceleration = acceleration;
        isStalled = false;
        stalledFor = 0;
        isToTell = false;
        hasNext = false;
        isBraking = false;
        state = MOVING;
        if (speed == 0 && (limit == NO_LIMIT || limit == -NO_LIMIT)) {
            this.limit = NO_LIMIT;
            target = 0;
        } else if (canReach(limit)) {
            this.limit = limit;
            target = isAhead(limit) ? speed : -speed;
        } else {
            hasNext = true;
            nextSpeed = speed;
            nextLimit = limit;
            this.limit = NO_LIMIT;
            target = 0;
        }
        return !wasMoving;
    }

    /** Lets the motor roll; it should stand when it could have braked. */
    void roll() {
        hasNext = false;
        if (state == FREE || state == HOLDING) {
            release();
            return;
        }
        if (state == ROLLING) return;
        port.controlMotor(0, BasicMotorPort.FLOAT);
        float time = acceleration > 0 ? 1000 * Math.abs(velocity) / acceleration : 0;
        arrivedAt = (int) System.currentTimeMillis() + (int) time;
        velocity = 0;
        state = ROLLING;
    }

    /** Lets the motor roll and forgets its move, and says whether it was held. */
    boolean release() {
        boolean wasActive = state != FREE;
        if (isMoving()) isToTell = true;
        tachoAtEnd = port.getTachoCount();
        port.controlMotor(0, BasicMotorPort.FLOAT);
        state = FREE;
        velocity = 0;
        hasNext = false;
        return wasActive;
    }

    /** Goes on by so many milliseconds, and says whether the move has ended. */
    boolean update(int now, int elapsed) {
        if (state == ROLLING) {
            if (now - arrivedAt < 0) return false;
            end(FREE, port.getTachoCount());
            return true;
        }
        int tacho = port.getTachoCount();
        float error = degrees - tacho + fraction;
        if (state == MOVING) {
            if (error > stallError || error < -stallError) {
                stalledFor++;
                if (stalledFor > stallCycles) {
                    stall(tacho);
                    return true;
                }
            } else {
                stalledFor >>= 1;
                if (velocity == 0 && target == 0 && limit == NO_LIMIT) {
                    arrive(now);
                } else {
                    advance(elapsed * 0.001f, now);
                }
                error = degrees - tacho + fraction;
            }
        }
        control(error);
        if (state == SETTLING) {
            int time = now - arrivedAt;
            if (time > LONGEST_SETTLE_TIME || time >= SETTLE_TIME && error < NEAR && error > -NEAR) {
                end(HOLDING, tacho);
                return true;
            }
        }
        return false;
    }

    /** Tells the listener if the move has ended. */
    void tellEnd() {
        if (!isToTell) return;
        isToTell = false;
        motor.tellStopped(tachoAtEnd, isStalled);
    }

    private void takeOver() {
        degrees = port.getTachoCount();
        fraction = 0;
        velocity = 0;
        fastError = 0;
        slowError = 0;
        basePower = 0;
    }

    private boolean isAhead(int limit) {
        return limit == NO_LIMIT || limit != -NO_LIMIT && limit - degrees - fraction >= 0;
    }

    /** Whether the motor can go on to the limit without turning round. */
    private boolean canReach(int limit) {
        if (velocity == 0) return true;
        if (velocity > 0 != isAhead(limit)) return false;
        if (limit == NO_LIMIT || limit == -NO_LIMIT) return true;
        float way = limit - degrees - fraction;
        return velocity * velocity <= 2 * acceleration * (way < 0 ? -way : way);
    }

    private void advance(float time, int now) {
        float old = velocity;
        boolean isLimited = limit != NO_LIMIT && limit != -NO_LIMIT;
        float way = 0;
        if (isLimited) {
            way = limit - degrees - fraction;
            float distance = way < 0 ? -way : way;
            if (!isBraking && old * old >= 2 * acceleration * distance) {
                isBraking = true;
                deceleration = distance > 0 ? old * old / (2 * distance) : acceleration;
            }
        }
        float wanted = isBraking ? 0 : target;
        float change = (isBraking ? deceleration : acceleration) * time;
        float difference = wanted - old;
        if (difference > change) {
            velocity = old + change;
        } else if (difference < -change) {
            velocity = old - change;
        } else {
            velocity = wanted;
        }
        float step = (old + velocity) * 0.5f * time;
        if (velocity == 0 && old != 0 && change > 0) step = old * (old < 0 ? -old : old) * 0.5f * time / change;
        boolean isThere = isLimited
            && (isBraking && velocity == 0 || (way < 0 ? step <= way : step >= way));
        if (isThere) {
            degrees = limit;
            fraction = 0;
            velocity = 0;
            arrive(now);
            return;
        }
        fraction += step;
        int whole = (int) fraction;
        degrees += whole;
        fraction -= whole;
        if (velocity == 0 && target == 0 && !isLimited) arrive(now);
    }

    /** The motor should stand now: begins the next move, or waits until the motor really stands. */
    private void arrive(int now) {
        if (hasNext) {
            hasNext = false;
            isBraking = false;
            limit = nextLimit;
            target = isAhead(limit) ? nextSpeed : -nextSpeed;
            return;
        }
        state = SETTLING;
        arrivedAt = now;
        limit = degrees;
    }

    private void control(float error) {
        fastError = 0.375f * fastError + 0.625f * error;
        slowError = 0.75f * slowError + 0.25f * error;
        float power;
        if (state == HOLDING) {
            power = basePower + HOLD_P * fastError + HOLD_D * (fastError - slowError);
            basePower += HOLD_I * (power - basePower);
        } else {
            power = basePower + MOVE_P * fastError + MOVE_D * (fastError - slowError);
            basePower += MOVE_I * (power - basePower);
        }
        if (basePower > 100) {
            basePower = 100;
        } else if (basePower < -100) {
            basePower = -100;
        }
        int rounded = (int) (power < 0 ? power - 0.5f : power + 0.5f);
        if (rounded > 0) {
            port.controlMotor(rounded > 100 ? 100 : rounded, BasicMotorPort.FORWARD);
        } else if (rounded < 0) {
            port.controlMotor(rounded < -100 ? 100 : -rounded, BasicMotorPort.BACKWARD);
        } else {
            port.controlMotor(0, BasicMotorPort.STOP);
        }
    }

    private void stall(int tacho) {
        isStalled = true;
        takeOver();
        target = 0;
        limit = degrees;
        hasNext = false;
        end(HOLDING, tacho);
    }

    private void end(int state, int tacho) {
        this.state = state;
        isToTell = true;
        tachoAtEnd = tacho;
    }
}
