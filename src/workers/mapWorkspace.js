/**
 * Maps of a workspace, off the page's thread: a question comes as plain data, words of progress with pictures so far go back,
 * and the answer with the question's own id. A new question, or one to stop, ends the work on the last one at its next step;
 * nothing more is said about that.
 *
 * @import { ChainDescription } from '../kinematics/chain.js'
 * @import { Word, WorkspaceJob, workspaceJob } from '../workspace/jobs.js'
 *
 * @typedef {{ id: number, chain: ChainDescription, job: WorkspaceJob } | { id: number, stop: true }} MapWorkspaceQuestion
 *
 * @typedef {ReturnType<typeof workspaceJob> extends Generator<unknown, infer A> ? A : never} MapWorkspaceFound
 * @typedef {{ id: number, word: Word } | { id: number, found: MapWorkspaceFound } | { id: number, fault: string }} MapWorkspaceAnswer
 *   fault: the question makes no sense, as the errors of the workspace's functions say
 */
import { transferable, workspaceJob as startJob } from '../workspace/jobs.js';

/** What is being worked on has this id; another's is given up. */
let current = 0;

/** A turn of the event loop, for questions to come in; timers would wait four milliseconds. */
const channel = new MessageChannel();

/** @param {MapWorkspaceAnswer} answer */
const say = (answer) => self.postMessage(answer, { transfer: [...transferable(answer)] });

self.onmessage = ({ data }) => {
  const question = /** @type {MapWorkspaceQuestion} */ (data);
  current = question.id;
  if ('stop' in question) return;
  const { id, chain, job } = question;
  const work = startJob(chain, job);

  const goOn = () => {
    try {
      const step = work.next();
      if (step.done) {
        say({ id, found: step.value });
        return;
      }
      say({ id, word: step.value });
    } catch (error) {
      say({ id, fault: error instanceof Error ? error.message : String(error) });
      return;
    }
    channel.port2.postMessage(id);
  };
  // what the last question has left behind in the queue is not for this one
  channel.port1.onmessage = ({ data: asked }) => {
    if (asked === current) goOn();
  };
  goOn();
};
