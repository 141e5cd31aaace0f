public class StateMachines {
    enum State {
        SEARCH {
            @Override
            State next(int light) {
                return light < 40 ? FOLLOW : SEARCH;
            }
        },
        FOLLOW {
            @Override
            State next(int light) {
                return light > 60 ? LOST : light == 0 ? DONE : FOLLOW;
            }
        },
        LOST {
            private int tries;

            @Override
            State next(int light) {
                return ++tries > 2 ? DONE : light < 40 ? FOLLOW : LOST;
            }
        },
        DONE;

        State next(int light) {
            return this;
        }

        boolean isOver() {
            return this == DONE;
        }
    }

    static int power(State state) {
        switch (state) {
            case SEARCH:
            case LOST:
                return 30;
            case FOLLOW:
                return 60;
            default:
                return 0;
        }
    }

    public static void main(String[] arguments) {
        int[] lights = {80, 70, 30, 35, 70, 80, 20, 90, 80, 70, 10};
        State state = State.SEARCH;
        for (int light : lights) {
            state = state.next(light);
            System.out.println(light + " " + state + " " + power(state)); // expect 80 SEARCH 30
            // expect 70 SEARCH 30
            // expect 30 FOLLOW 60
            // expect 35 FOLLOW 60
            // expect 70 LOST 30
            // expect 80 LOST 30
            // expect 20 FOLLOW 60
            // expect 90 LOST 30
            // expect 80 DONE 0
            if (state.isOver()) break;
        }
        int[] times = new int[State.values().length];
        for (State one : State.values()) times[one.ordinal()] += one.name().length();
        System.out.println(times[0] + times[1] + times[2] + times[3]); // expect 20
    }
}
